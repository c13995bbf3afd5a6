// SPDX-License-Identifier: BSD-3-Clause
#include "sim/render/scratch_dir.h"

#include <gtest/gtest.h>

#include "tests/support/temp_folder.h"

namespace sidestep::render::scratch_dir_test {
namespace {

namespace fs = std::filesystem;

TEST(ScratchDirTest, IsBesideItsFileAndGoesWithItsScope) {
  const TempFolder folder;
  fs::path kept;
  {
    const ScratchDir scratch(folder.path() / "run/video.mp4");
    kept = scratch.path();
    EXPECT_EQ(kept.parent_path(), folder.path() / "run");
    folder.Write("run/" + kept.filename().string() + "/part", "whole");
    scratch.MoveOut("part", folder.path() / "run/video.mp4");
  }
  EXPECT_FALSE(fs::exists(kept));
  EXPECT_TRUE(fs::exists(folder.path() / "run/video.mp4"));
}

TEST(ScratchDirTest, TakesAwayWhatKilledProcessesLeftAndNothingThatIsInUse) {
  const TempFolder folder;
  const fs::path abandoned = folder.Write(".render.99999999/part0.mkv", "half a film");
  const fs::path other = folder.Write("render.txt", "somebody's");
  const ScratchDir first(folder.path() / "a.mp4");
  EXPECT_FALSE(fs::exists(abandoned.parent_path()));
  EXPECT_TRUE(fs::exists(other));
  // Another process's would have another name; its lock is what counts.
  const fs::path moved = folder.path() / ".render.1";
  fs::rename(first.path(), moved);
  const ScratchDir second(folder.path() / "b.mp4");
  EXPECT_TRUE(fs::exists(moved));
  fs::remove_all(moved);
}

}  // namespace
}  // namespace sidestep::render::scratch_dir_test
