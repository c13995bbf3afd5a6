// SPDX-License-Identifier: BSD-3-Clause
// Runs of unlike length drawn beside each other.

#include "sim/render/side_by_side.h"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "tests/support/synthetic_run.h"
#include "tests/unit/render/render_test_support.h"

namespace sidestep::side_by_side_test {
namespace {

namespace fs = std::filesystem;
using render_test_support::DecodedRgb;
using render_test_support::ErrorOf;
using render_test_support::Probe;

constexpr int kHalf_px = 64;

RenderOptions Small() {
  RenderOptions options;
  options.width_px = kHalf_px;
  options.height_px = kHalf_px;
  options.fps = 20;
  options.quality = RenderQuality::kDraft;
  return options;
}

// The first run is over at 0.5 s, the second one at 1 s.
class SideBySideTest : public ::testing::Test {
 protected:
  SideBySideTest() : dir_(testing::FreshTestDir("side_by_side")) {
    testing::WriteSyntheticRun(dir_ / "short");
    testing::WriteSyntheticRun(dir_ / "long", {.duration_s = 1.0});
  }

  std::string ErrorFrom(double from_s, std::optional<double> to_s = {}) const {
    RenderOptions options = Small();
    options.from_s = from_s;
    options.to_s = to_s;
    return ErrorOf([&] { RenderSideBySide(runs_, options, film_); });
  }

  fs::path dir_;
  std::array<fs::path, 2> runs_{dir_ / "short", dir_ / "long"};
  fs::path film_{dir_ / "film.mp4"};
};

TEST_F(SideBySideTest, ARunThatIsOverBeforeTheFilmBeginsShowsItsLastState) {
  RenderOptions options = Small();
  options.from_s = 0.7;
  RenderSideBySide(runs_, options, film_);
  const nlohmann::json stream = Probe(film_);
  EXPECT_EQ(stream.at("nb_read_frames"), "6") << "0.3 s at 20 frames a second";
  const int width_px = stream.at("width"), height_px = stream.at("height");
  const std::string rgb = DecodedRgb(film_);
  const auto byte = [&](int frame, int x, int y) {
    const int pixel = (frame * height_px + y) * width_px + x;
    return static_cast<int>(
        static_cast<unsigned char>(rgb.at(static_cast<std::size_t>(3 * pixel))));
  };
  // How much the pictures of a half, below their headings, change in all.
  const auto change = [&](int first_x) {
    double sum = 0.0;
    for (int y = height_px - kHalf_px; y < height_px; ++y) {
      for (int x = first_x; x < first_x + kHalf_px; ++x) {
        sum += std::abs(byte(5, x, y) - byte(0, x, y));
      }
    }
    return sum / (kHalf_px * kHalf_px);
  };
  EXPECT_LT(change(0), 1.0) << "stands still, but for its encoding";
  EXPECT_GT(change(width_px - kHalf_px), change(0)) << "moves";
}

TEST_F(SideBySideTest, APartThatNeitherRunHasIsALineThatNamesBothAndDrawsNothing) {
  EXPECT_EQ(ErrorFrom(1.5), "sidestep: error: nothing from 1.5 s on: " + runs_[0].string() +
                                " ends at 0.5 s, " + runs_[1].string() + " at 1 s");
  EXPECT_EQ(ErrorFrom(0.9, 0.8),
            "sidestep: error: nothing from 0.9 s to 0.8 s: the run is from 0 s to 1 s");
  EXPECT_EQ(std::distance(fs::directory_iterator(dir_), {}), 2) << "the runs";
}

}  // namespace
}  // namespace sidestep::side_by_side_test
