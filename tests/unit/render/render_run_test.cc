// SPDX-License-Identifier: BSD-3-Clause
#include "sim/render/render_run.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>

#include "models/support/config_error.h"
#include "sim/process/process.h"
#include "sim/record/run_files.h"
#include "tests/support/run_files.h"
#include "tests/support/synthetic_run.h"
#include "tests/unit/render/render_test_support.h"

namespace sidestep::render_run_test {
namespace {

using ::sidestep::render_test_support::ErrorOf;
using ::sidestep::render_test_support::Probe;
using ::sidestep::render_test_support::WithoutPrograms;
using ::sidestep::testing::FreshTestDir;
using ::sidestep::testing::SyntheticRun;
using ::sidestep::testing::WriteSyntheticRun;

RenderOptions Small() {
  RenderOptions options;
  options.width_px = 160;
  options.height_px = 120;
  options.fps = 20;
  options.quality = RenderQuality::kDraft;
  return options;
}

/// Number of pixels of the push arrow's magenta in a picture.
int PushPixels(const std::filesystem::path& png) {
  const std::string pixels = render_test_support::DecodedRgb(png);
  int count = 0;
  for (std::size_t i = 0; i + 2 < pixels.size(); i += 3) {
    const auto channel = [&](std::size_t k) {
      return static_cast<int>(static_cast<unsigned char>(pixels[i + k]));
    };
    if (channel(0) > 190 && channel(1) < 60 && channel(2) > 90 && channel(2) < 200) ++count;
  }
  return count;
}

TEST(RenderRunTest, TheVideoHasAFrameForEachTickOfItsRateInAnyNumberOfJobs) {
  const auto dir = FreshTestDir("render_frames");
  WriteSyntheticRun(dir);
  for (const int jobs : {1, 2, 3}) {
    RenderOptions options = Small();
    options.jobs = jobs;
    RenderRun(dir, options);
    const nlohmann::json stream = Probe(dir / "video.mp4");
    EXPECT_EQ(stream.at("nb_read_frames"), "10") << jobs << " jobs: 0.5 s at 20 frames a second";
    EXPECT_EQ(stream.at("codec_name"), "h264");
    EXPECT_EQ(stream.at("pix_fmt"), "yuv420p") << "what browsers play";
    EXPECT_EQ(stream.at("width"), 160);
    EXPECT_EQ(stream.at("r_frame_rate"), "20/1");
    EXPECT_NEAR(std::stod(stream.at("container_duration").get<std::string>()), 0.5, 0.051);
  }
}

TEST(RenderRunTest, TheIndexComesBeforeThePictures) {
  const auto dir = FreshTestDir("render_faststart");
  WriteSyntheticRun(dir);
  RenderRun(dir, Small());
  const std::string bytes = TextOf(dir / "video.mp4");
  EXPECT_LT(bytes.find("moov"), bytes.find("mdat"));
}

TEST(RenderRunTest, NothingButTheVideoAndItsPlaceOnTheListIsLeftBehind) {
  const auto dir = FreshTestDir("render_clean");
  WriteSyntheticRun(dir);
  const auto count = [&] { return std::distance(std::filesystem::directory_iterator(dir), {}); };
  const auto before = count();
  RenderRun(dir, Small());
  EXPECT_EQ(count(), before + 2);
  EXPECT_EQ(ListedRunFiles(dir), std::vector<std::string>{"video.mp4"});
}

TEST(RenderRunTest, ProgressGrowsToOne) {
  const auto dir = FreshTestDir("render_progress");
  WriteSyntheticRun(dir);
  RenderOptions options = Small();
  options.jobs = 2;
  double last = 0.0;
  options.on_progress = [&](double share) {
    EXPECT_GE(share, last);
    last = share;
  };
  RenderRun(dir, options);
  EXPECT_DOUBLE_EQ(last, 1.0);
}

TEST(RenderRunTest, ThePushArrowIsSeenWhileThePushActsAndNotBeforeOrAfter) {
  const auto dir = FreshTestDir("render_push");
  WriteSyntheticRun(dir);  // pushes from 0.2 s to 0.3 s
  const auto pixels_at = [&](double time_s) {
    WriteFramePngs(dir, {{time_s, dir / "frame.png"}}, Small());
    return PushPixels(dir / "frame.png");
  };
  EXPECT_EQ(pixels_at(0.15), 0);
  EXPECT_GT(pixels_at(0.25), 60);
  EXPECT_EQ(pixels_at(0.45), 0);
}

/// Whether words stand in a picture of 240 rows: their boxes are darker than anything else there.
bool HasWords(const std::filesystem::path& dir, bool has_captions) {
  RenderOptions options = Small();
  options.width_px = 320;
  options.height_px = 240;
  options.has_captions = has_captions;
  WriteFramePngs(dir, {{0.1, dir / "frame.png"}}, options);
  const std::string pixels = render_test_support::DecodedRgb(dir / "frame.png");
  const auto box = static_cast<std::size_t>(3 * (320 * 8 + 8));  // in the box of the name
  return static_cast<unsigned char>(pixels.at(box)) < 100;
}

TEST(RenderRunTest, WordsAreLeftOutWhenAsked) {
  const auto dir = FreshTestDir("render_words");
  WriteSyntheticRun(dir);
  EXPECT_TRUE(HasWords(dir, true));
  EXPECT_FALSE(HasWords(dir, false));
}

TEST(RenderRunTest, ManyPicturesAreDrawnAtOnceEachAtItsTime) {
  const auto dir = FreshTestDir("render_pictures");
  WriteSyntheticRun(dir);
  WriteFramePngs(dir, {{0.15, dir / "a.png"}, {0.25, dir / "b.png"}, {99.0, dir / "c.png"}},
                 Small());
  EXPECT_EQ(PushPixels(dir / "a.png"), 0);
  EXPECT_GT(PushPixels(dir / "b.png"), 60);
  EXPECT_EQ(PushPixels(dir / "c.png"), 0) << "the last frame";
}

TEST(RenderRunTest, ARunCutShortWithinARowIsStillDrawn) {
  const auto dir = FreshTestDir("render_truncated");
  WriteSyntheticRun(dir);
  std::filesystem::resize_file(dir / "states.bin",
                               std::filesystem::file_size(dir / "states.bin") - 13);
  RenderRun(dir, Small());
  EXPECT_EQ(Probe(dir / "video.mp4").at("nb_read_frames"), "10") << "0.49 s round to 10 frames";
}

TEST(RenderRunTest, AMissingFileIsNamed) {
  for (const char* file : {"states.bin", "footsteps.csv", "summary.json", "scenario.yaml"}) {
    const auto dir = FreshTestDir("render_missing");
    WriteSyntheticRun(dir);
    std::filesystem::remove(dir / file);
    const std::string error = ErrorOf([&] { RenderRun(dir, Small()); });
    EXPECT_NE(error.find((dir / file).string()), std::string::npos) << error;
  }
}

TEST(RenderRunTest, WithoutFfmpegTheErrorSaysSoAndTheOldVideoStays) {
  const auto dir = FreshTestDir("render_no_ffmpeg");
  WriteSyntheticRun(dir);
  std::ofstream(dir / "video.mp4") << "an older video";
  const WithoutPrograms no_path;
  const std::string error = ErrorOf([&] { RenderRun(dir, Small()); });
  EXPECT_NE(error.find("can't start ffmpeg"), std::string::npos) << error;
  EXPECT_EQ(TextOf(dir / "video.mp4"), "an older video");
}

TEST(RenderRunTest, AFailingFfmpegIsQuotedAndTheOldVideoStays) {
  const auto dir = FreshTestDir("render_bad_ffmpeg");
  WriteSyntheticRun(dir);
  std::ofstream(dir / "video.mp4") << "an older video";
  const auto programs = dir / "bin";
  std::filesystem::create_directories(programs);
  std::ofstream(programs / "ffmpeg") << "#!/bin/sh\necho 'no space left on device' >&2\nexit 3\n";
  std::filesystem::permissions(programs / "ffmpeg", std::filesystem::perms::owner_all);
  const std::string path = std::getenv("PATH");
  setenv("PATH", (programs.string() + ":" + path).c_str(), 1);
  RenderOptions options = Small();
  options.jobs = 2;
  const std::string error = ErrorOf([&] { RenderRun(dir, options); });
  setenv("PATH", path.c_str(), 1);
  EXPECT_NE(error.find("exit code 3: no space left on device"), std::string::npos) << error;
  EXPECT_EQ(TextOf(dir / "video.mp4"), "an older video");
}

TEST(RenderRunTest, AnOddSizeIsRefusedBeforeAnyWork) {
  const auto dir = FreshTestDir("render_odd");
  WriteSyntheticRun(dir);
  RenderOptions options = Small();
  options.width_px = 161;
  EXPECT_NE(ErrorOf([&] { RenderRun(dir, options); }).find("161 x 120"), std::string::npos);
}

TEST(RenderRunTest, TheScenarioChoosesSizeRateAndCamera) {
  const auto dir = FreshTestDir("render_options");
  WriteSyntheticRun(dir);
  const RenderOptions options = RenderOptionsOf(dir);
  EXPECT_EQ(options.width_px, 160);
  EXPECT_EQ(options.height_px, 120);
  EXPECT_EQ(options.fps, 20);
}

}  // namespace
}  // namespace sidestep::render_run_test
