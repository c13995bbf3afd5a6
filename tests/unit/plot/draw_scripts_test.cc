// SPDX-License-Identifier: BSD-3-Clause
#include "sim/plot/draw_scripts.h"

#include <gtest/gtest.h>

#include "tests/support/run_files.h"
#include "tests/support/temp_folder.h"

namespace sidestep::draw_scripts_test {
namespace {

namespace fs = std::filesystem;

constexpr const char* kGood = "set terminal svg\nset output \"good.\".format.ending\nplot x\n";
constexpr const char* kBad = "set terminal svg\nset output \"bad.\".format.ending\nplot no_such\n";

TEST(DrawScriptsTest, EachFormatIsDrawnOnceHoweverOftenItIsAskedFor) {
  const TempFolder folder;
  folder.Write("good.gp", kGood);
  const auto pictures = plot::DrawScripts({"good"}, {"svg", "svg"}, folder.path());
  EXPECT_EQ(pictures, std::vector<fs::path>{folder.path() / "good.svg"});
  EXPECT_TRUE(TextOf(pictures[0]).ends_with("</svg>\n\n")) << "whole";
}

TEST(DrawScriptsTest, WhatFailsLeavesTheOldPicturesAndNoHalfOnes) {
  const TempFolder folder;
  folder.Write("good.gp", kGood);
  folder.Write("bad.gp", kBad);
  const fs::path old = folder.Write("good.svg", "an older one");
  EXPECT_THROW(plot::DrawScripts({"good", "bad"}, {"svg"}, folder.path()), ConfigError);
  EXPECT_EQ(TextOf(old), "an older one");
  for (const auto& entry : fs::directory_iterator(folder.path())) {
    EXPECT_NE(entry.path().extension(), ".part") << entry.path();
  }
}

}  // namespace
}  // namespace sidestep::draw_scripts_test
