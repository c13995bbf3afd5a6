// SPDX-License-Identifier: BSD-3-Clause
// Text that is drawn runs nothing, and a user's own settings change no picture.
#include "sim/process/gnuplot.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "models/support/config_error.h"
#include "tests/support/temp_folder.h"

namespace sidestep::gnuplot_test {
namespace {

TEST(GnuplotTest, ANameCannotEndItsQuotes) {
  EXPECT_EQ(GnuplotText("it's `rm` \"x\"\n"), "'it''s `rm` \"x\" '");
}

TEST(GnuplotTest, WhatIsQuotedIsPrintedAsItIs) {
  const TempFolder folder;
  const std::string text = "`touch PWNED` $(touch PWNED) 'x' \\ %d @y";
  const std::string said =
      RunGnuplot({"-"}, "set print '-'\nprint " + GnuplotText(text) + "\n", folder.path());
  EXPECT_EQ(said, text + "\n");
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "PWNED"));
}

TEST(GnuplotTest, AUsersOwnSettingsAreNotRead) {
  const TempFolder home;
  home.Write(".gnuplot", "set print '-'\nprint 'settings'\n");
  const std::string before = std::getenv("HOME") == nullptr ? "/" : std::getenv("HOME");
  setenv("HOME", home.path().c_str(), 1);
  const std::string said = RunGnuplot({"-"}, "set print '-'\nprint 'script'\n");
  setenv("HOME", before.c_str(), 1);
  EXPECT_EQ(said, "script\n");
}

TEST(GnuplotTest, AScriptThatFailsIsAnError) {
  EXPECT_THROW(RunGnuplot({"-"}, "no such command\n"), ConfigError);
}

}  // namespace
}  // namespace sidestep::gnuplot_test
