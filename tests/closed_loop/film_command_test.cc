// SPDX-License-Identifier: BSD-3-Clause
// `film` and `render` as the shell sees them: what they write, and what they refuse.

#include <gtest/gtest.h>

#include <filesystem>
#include <iterator>
#include <string>
#include <vector>

#include "sim/process/process.h"
#include "tests/support/run_files.h"
#include "tests/support/sidestep_program.h"
#include "tests/support/temp_folder.h"

namespace sidestep::film_command_test {
namespace {

namespace fs = std::filesystem;

constexpr const char* kStanding =
    "sidestep: 1\nname: standing\nrobot: hopper\nduration_s: 0.3\nexpect: {fall: false}\n";

// A short run with a small video, or with none.
void RunInto(const TempFolder& folder, const fs::path& out, const std::string& video) {
  const fs::path file = folder.Write("s.yaml", kStanding);
  const ProcessResult result =
      Sidestep({"run", file, "-o", out, "--no-plots", "-q", "--set", "video=" + video});
  ASSERT_EQ(result.exit_code, 0) << result.err;
}

TEST(FilmCommandTest, TwoRunsBecomeOneFilmAndOneStrip) {
  const TempFolder folder;
  const fs::path left = folder.path() / "left", right = folder.path() / "right";
  RunInto(folder, left, "{size: [80, 64], fps: 10}");
  RunInto(folder, right, "{size: [64, 80], fps: 20}");
  const fs::path film = folder.path() / "film.mp4", strip = folder.path() / "strip.png";
  const std::vector<std::string> words{"film", left,      right,     "-o",       film,   "--strip",
                                       strip,  "--times", "0.1,0.9", "--labels", "a,b c"};
  const ProcessResult result = Sidestep(words);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.out, film.string() + "\n" + strip.string() + "\n");
  EXPECT_GT(fs::file_size(film), 0U);
  EXPECT_EQ(TextOf(strip).substr(1, 3), "PNG");
  const ProcessResult again = Sidestep(words);
  EXPECT_EQ(again.exit_code, 2);
  EXPECT_EQ(again.err, film.string() + ": error: is there already; --force replaces it\n");
}

TEST(FilmCommandTest, MistakesAreTwoAndOneLineAndLeaveNothing) {
  const TempFolder folder;
  const fs::path run = folder.path() / "run", film = folder.path() / "film.mp4";
  RunInto(folder, run, "false");
  const std::string absent = folder.path() / "absent" / "film.mp4";
  for (const std::vector<std::string>& arguments : std::vector<std::vector<std::string>>{
           {run},
           {run, run},
           {run, run, "-o", film},  // it has no video
           {run, folder.path(), "-o", film},
           {run, folder.path() / "absent", "-o", film},
           {run, run, "-o", absent},
           {run, run, "-o", folder.path()},
           {run, run, "-o", film, "--labels", "one"},
           {run, run, "-o", film, "--times", "1"},
           {run, run, "--strip", film},
           {run, run, "--strip", film, "--times", "-1"},
           {run, run, "--strip", film, "--times", "0.1,nan"},
           {run, run, "--strip", film, "--times", "0,1,2,3,4,5,6,7,8,9,10,11,12"}}) {
    std::vector<std::string> words{"film"};
    words.insert(words.end(), arguments.begin(), arguments.end());
    ExpectMistake(words);
  }
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 2) << "s.yaml and run";
  folder.Write("run/video.mp4", "mine");
  EXPECT_EQ(Sidestep({"film", run, run, "-o", run / "video.mp4", "--force"}).exit_code, 2);
  EXPECT_EQ(TextOf(run / "video.mp4"), "mine");
}

TEST(RenderCommandTest, APartOfARunIsDrawnAsAskedBesideItsVideo) {
  const TempFolder folder;
  const fs::path run = folder.path() / "run";
  RunInto(folder, run, "{size: [80, 64], fps: 10}");
  const std::string before = TextOf(run / "video.mp4");
  const ProcessResult result =
      Sidestep({"render", run, "--from", "0.1", "--to", "0.2", "--speed", "0.25", "--camera",
                "side", "--size", "96x64", "--gif", "-q", "-j", "1"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.out, (run / "clip.gif").string() + "\n");
  const std::string gif = TextOf(run / "clip.gif");
  EXPECT_EQ(gif.substr(0, 6), "GIF89a");
  EXPECT_EQ(gif.substr(6, 4), std::string("\x60\0\x40\0", 4)) << "96 x 64";
  EXPECT_EQ(TextOf(run / "video.mp4"), before) << "the run's own video stays";
  EXPECT_NE(TextOf(run / "run_files.txt").find("clip.gif"), std::string::npos);
}

TEST(RenderCommandTest, TwoRunsAreDrawnSideBySideWithoutVideosOfTheirOwn) {
  const TempFolder folder;
  const fs::path left = folder.path() / "left", right = folder.path() / "right";
  RunInto(folder, left, "false");
  RunInto(folder, right, "false");
  const ProcessResult result = Sidestep(
      {"render", left, right, "--side-by-side", "--size", "96x64", "--to", "0.2", "-q", "-j", "1"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_GT(fs::file_size(left / "side_by_side.mp4"), 0U);
  for (const fs::path& run : {left, right}) {
    EXPECT_FALSE(fs::exists(run / "video.mp4"));
    for (const auto& entry : fs::directory_iterator(run)) {
      EXPECT_FALSE(entry.path().filename().string().starts_with(".render")) << entry.path();
    }
  }
}

TEST(RenderCommandTest, MistakesAreTwoAndOneLineThatTellsWhatWasExpected) {
  const TempFolder folder;
  const fs::path run = folder.path() / "run";
  RunInto(folder, run, "false");
  const std::vector<std::pair<std::vector<std::string>, std::string>> mistakes{
      {{run, "--time", "0.1"}, "--time requires --frame"},
      {{run, "--frame", "f.png", "--time", "-1"}, "not a time"},
      {{run, "--frame", "f.png", "--gif"}, "excludes"},
      {{run, "--from", "0.2", "--to", "0.1"}, "the run is from 0 s to 0.3"},
      {{run, "--from", "nan"}, "not a time"},
      {{run, "--speed", "0"}, "from 0.01 to 100"},
      {{run, "--camera", "beside"}, "follow"},
      {{run, "--size", "95x64"}, "expected WIDTHxHEIGHT"},
      {{run, "--size", "96x64px"}, "expected WIDTHxHEIGHT"},
      {{run, "-o", folder.path() / "film.avi"}, "expected a name in .mp4"},
      {{run, "-o", folder.path() / "film.gif"}, "--gif"},
      {{run, run}, "two with --side-by-side"},
      {{run, "--side-by-side"}, "two runs"},
      {{run, folder.path() / "absent", "--side-by-side"}, "is not a folder"}};
  for (const auto& [arguments, expected] : mistakes) {
    std::vector<std::string> words{"render"};
    words.insert(words.end(), arguments.begin(), arguments.end());
    ExpectMistake(words, expected);
  }
  EXPECT_FALSE(fs::exists(run / "clip.mp4"));
}

}  // namespace
}  // namespace sidestep::film_command_test
