// SPDX-License-Identifier: BSD-3-Clause
// Films of made-up videos, decoded again: what stands where, and when.

#include "sim/render/film.h"

#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "sim/record/run_summary.h"
#include "tests/support/run_files.h"
#include "tests/support/synthetic_run.h"
#include "tests/unit/render/render_test_support.h"

namespace sidestep::film_test {
namespace {

namespace fs = std::filesystem;
using render_test_support::DecodedRgb;
using render_test_support::ErrorOf;
using render_test_support::Probe;
using render_test_support::WithoutPrograms;
using ::sidestep::testing::FreshTestDir;
using ::sidestep::testing::WriteSyntheticRun;

constexpr double kFall_s = 0.4;  // of the run on the left

/// A video of two colours, the second one from half its time on.
struct TwoColours {
  std::string size;  ///< As ffmpeg has it.
  int fps{0};
  double half_s{0.0};
  std::string first, second;
};

void WriteVideo(const fs::path& file, const TwoColours& video) {
  const auto source = [&](const std::string& color) {
    return "color=" + color + ":s=" + video.size + ":r=" + std::to_string(video.fps) +
           ":d=" + std::to_string(video.half_s);
  };
  RunOrThrow({"ffmpeg", "-v", "error", "-f", "lavfi", "-i", source(video.first), "-f", "lavfi",
              "-i", source(video.second), "-filter_complex", "[0:v][1:v]concat", "-c:v", "libx264",
              "-pix_fmt", "yuv420p", "file:" + file.string()});
}

/// Two runs in folders whose names ask for care: the left one's video is 64 x 48 at 20 frames a
/// second, red for 0.25 s and green for 0.25 s; it falls at 0.4 s. The right one's is half as
/// large, half as fast and twice as long, blue and then white; it stands, as it is asked to.
std::array<FilmedRun, 2> TwoRuns(const fs::path& dir, const std::string& large = "64x48",
                                 const std::string& small = "32x24") {
  const fs::path left = dir / "it's: 'a', [b];", right = dir / "-b %d.mp4";
  RunSummary summary;
  summary.name = "left_run";
  summary.verdict = VerdictClass::kPass;
  summary.metrics = {{"fall", true}, {"fall_time_s", kFall_s}};
  summary.simulated_s = 0.5;
  for (const fs::path& run_dir : {left, right}) {
    fs::create_directories(run_dir);
    std::ofstream(run_dir / "summary.json") << SummaryJson(summary);
    summary.metrics = {{"fall", false}};
    summary.simulated_s = 1.7;  // its last second begins at 0.7 s
  }
  WriteVideo(left / "video.mp4", {large, 20, 0.25, "red", "lime"});
  WriteVideo(right / "video.mp4", {small, 10, 0.5, "blue", "white"});
  return {FilmedRun{left, ""}, FilmedRun{right, ""}};
}

/// A decoded film's pixels.
class Film {
 public:
  explicit Film(const fs::path& file) : stream_(Probe(file)), rgb_(DecodedRgb(file)) {}

  int width_px() const { return stream_.at("width"); }
  int height_px() const { return stream_.at("height"); }
  std::size_t frames() const {
    return rgb_.size() / static_cast<std::size_t>(3 * width_px() * height_px());
  }
  const nlohmann::json& stream() const { return stream_; }

  /// A letter for each channel that is on: "R", "RGB", "" for black; '?' for what is in between.
  std::string ColourAt(std::size_t frame, int x, int y) const {
    std::string name;
    for (std::size_t channel = 0; channel < 3; ++channel) {
      const int value = ChannelAt(frame, x, y, channel);
      if (value > 130) name += "RGB"[channel];
      if (value > 90 && value < 130) name += '?';
    }
    return name;
  }

  int ChannelAt(std::size_t frame, int x, int y, std::size_t channel) const {
    const auto width = static_cast<std::size_t>(width_px());
    const auto height = static_cast<std::size_t>(height_px());
    const std::size_t pixel =
        (frame * height + static_cast<std::size_t>(y)) * width + static_cast<std::size_t>(x);
    return static_cast<unsigned char>(rgb_.at(3 * pixel + channel));
  }

  /// Number of white pixels of a frame in a rectangle.
  int WhitePixels(std::size_t frame, int from_x, int to_x, int from_y, int to_y) const {
    int count = 0;
    for (int y = from_y; y < to_y; ++y) {
      for (int x = from_x; x < to_x; ++x) count += ColourAt(frame, x, y) == "RGB";
    }
    return count;
  }

 private:
  nlohmann::json stream_;
  std::string rgb_;
};

TEST(FilmTest, BothRunsAreOnOneTimeAxisAndTheShorterOneStandsStill) {
  const auto dir = FreshTestDir("film_halves");
  const fs::path mp4 = dir / "a 'film': x.mp4";
  WriteFilm(TwoRuns(dir), mp4);
  const Film film(mp4);
  EXPECT_EQ(film.frames(), 20U) << "1 s at the faster video's 20 frames a second";
  EXPECT_EQ(film.stream().at("r_frame_rate"), "20/1");
  EXPECT_EQ(film.stream().at("pix_fmt"), "yuv420p") << "what browsers play";
  ASSERT_EQ(film.width_px(), 64 + 64) << "the smaller one grows; no gap at this size";
  ASSERT_EQ(film.height_px(), 8 + 48);
  const auto left = [&](std::size_t frame) { return film.ColourAt(frame, 32, 8 + 24); };
  const auto right = [&](std::size_t frame) { return film.ColourAt(frame, 64 + 32, 8 + 24); };
  EXPECT_EQ(left(0), "R");
  EXPECT_EQ(left(4), "R") << "0.20 s";
  EXPECT_EQ(left(5), "G") << "0.25 s";
  EXPECT_EQ(left(19), "G") << "its last frame, long after its end";
  EXPECT_EQ(right(0), "B");
  EXPECT_EQ(right(9), "B") << "0.45 s";
  EXPECT_EQ(right(10), "RGB") << "0.50 s";
  EXPECT_EQ(right(19), "RGB");
}

TEST(FilmTest, TheBarTurnsToTheOutcomesColourWhenItIsDecided) {
  const auto dir = FreshTestDir("film_bars");
  WriteFilm(TwoRuns(dir), dir / "film.mp4");
  const Film film(dir / "film.mp4");
  const auto red = [&](std::size_t frame) { return film.ChannelAt(frame, 1, 1, 0); };
  const auto green = [&](std::size_t frame) { return film.ChannelAt(frame, 64 + 62, 1, 1); };
  EXPECT_LT(red(7), 60) << "0.35 s";
  EXPECT_GT(red(8), 150) << "0.40 s: it falls";
  EXPECT_GT(red(19), 150);
  EXPECT_LT(green(13), 60) << "0.65 s";
  EXPECT_GT(green(14), 85) << "0.70 s: the run's last second";
}

TEST(FilmTest, LabelsAndOutcomesAreWrittenAboveTheirHalves) {
  const auto dir = FreshTestDir("film_words");
  std::array<FilmedRun, 2> runs = TwoRuns(dir, "320x240", "160x120");
  runs[0].label = "it's 50%: [a],b;\\ %{pts}";
  runs[1].label = " ";
  WriteFilm(runs, dir / "film.mp4");
  const Film film(dir / "film.mp4");
  ASSERT_EQ(film.width_px(), 320 + 2 + 320);
  EXPECT_GT(film.WhitePixels(0, 0, 320, 0, 20), 60) << "the label on the left";
  EXPECT_EQ(film.WhitePixels(0, 322, 642, 0, 20), 0) << "a label of a blank on the right";
  EXPECT_EQ(film.WhitePixels(0, 0, 320, 21, 40), 0) << "no outcome yet";
  EXPECT_GT(film.WhitePixels(10, 0, 320, 21, 40), 60) << "it has fallen";
}

TEST(FilmTest, AStripHasARowARunAndAColumnATime) {
  const auto dir = FreshTestDir("film_strip");
  WriteSyntheticRun(dir / "left");
  WriteSyntheticRun(dir / "right");
  WriteStrip({FilmedRun{dir / "left", "a"}, FilmedRun{dir / "right", ""}}, {0.1, 0.25},
             dir / "strip.png");
  const nlohmann::json picture = Probe(dir / "strip.png");
  EXPECT_EQ(picture.at("width"), 2 * 350);
  EXPECT_EQ(picture.at("height"), 2 * (38 + 350));
  const Film strip(dir / "strip.png");
  const auto has_arrow = [&](int from_x, int from_y) {  // magenta: the push, at 0.25 s only
    int count = 0;
    for (int y = from_y; y < from_y + 350; ++y) {
      for (int x = from_x; x < from_x + 350; ++x) {
        count += strip.ChannelAt(0, x, y, 0) > 210 && strip.ChannelAt(0, x, y, 1) < 60;
      }
    }
    return count > 100;
  };
  EXPECT_FALSE(has_arrow(0, 38));
  EXPECT_TRUE(has_arrow(350, 38));
  EXPECT_FALSE(has_arrow(0, 2 * 38 + 350));
  EXPECT_TRUE(has_arrow(350, 2 * 38 + 350));
}

// All that lies in a folder, in order.
std::vector<fs::path> FilesOf(const fs::path& dir) {
  std::vector<fs::path> files{fs::directory_iterator(dir), {}};
  std::sort(files.begin(), files.end());
  return files;
}

TEST(FilmTest, MistakesAreNamedAndLeaveNothingBehind) {
  const auto dir = FreshTestDir("film_mistakes");
  const std::array<FilmedRun, 2> runs = TwoRuns(dir);
  const fs::path mp4 = dir / "film.mp4";
  std::ofstream(mp4) << "an older film";
  const std::vector<fs::path> before = FilesOf(dir);
  const auto error = [&] { return ErrorOf([&] { WriteFilm(runs, mp4); }); };
  {
    const WithoutPrograms no_path;
    EXPECT_NE(error().find("can't start ffmpeg"), std::string::npos) << error();
  }
  std::ofstream(runs[1].run_dir / "video.mp4") << "no video";
  EXPECT_NE(error().find("Invalid data"), std::string::npos) << error();
  fs::remove(runs[1].run_dir / "video.mp4");
  EXPECT_EQ(error().find((runs[1].run_dir / "video.mp4").string() + ": error: "), 0U) << error();
  fs::remove(runs[0].run_dir / "summary.json");
  fs::copy(runs[0].run_dir / "video.mp4", runs[1].run_dir / "video.mp4");
  EXPECT_NE(error().find("summary.json"), std::string::npos) << error();
  EXPECT_EQ(TextOf(mp4), "an older film");
  EXPECT_EQ(FilesOf(dir), before);
}

TEST(FilmTest, AnFfmpegThatFailsHalfWayIsQuotedAndLeavesNothingBehind) {
  const auto dir = FreshTestDir("film_bad_ffmpeg");
  const std::array<FilmedRun, 2> runs = TwoRuns(dir);
  const fs::path programs = FreshTestDir("film_bad_ffmpeg_bin");
  std::ofstream(programs / "ffmpeg") << "#!/bin/sh\n[ \"$1\" = -version ] && exit 0\n"
                                        "echo half a film >film.mp4\n"
                                        "echo 'no space left on device' >&2\nexit 3\n";
  fs::permissions(programs / "ffmpeg", fs::perms::owner_all);
  std::ofstream(programs / "ffprobe") << "#!/bin/sh\nPATH=/usr/bin exec ffprobe \"$@\"\n";
  fs::permissions(programs / "ffprobe", fs::perms::owner_all);
  const std::vector<fs::path> before = FilesOf(dir);
  const WithoutPrograms ours(programs);
  const std::string error = ErrorOf([&] { WriteFilm(runs, dir / "film.mp4"); });
  EXPECT_NE(error.find("exit code 3: no space left on device"), std::string::npos) << error;
  EXPECT_EQ(FilesOf(dir), before);
}

}  // namespace
}  // namespace sidestep::film_test
