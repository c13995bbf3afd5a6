// SPDX-License-Identifier: BSD-3-Clause
#include "models/mjcf/mjcf_sizes.h"

#include <gtest/gtest.h>

#include <string>

#include "models/robot_description/mjcf_names.h"
#include "tests/support/temp_folder.h"

namespace sidestep::mjcf_sizes_test {
namespace {

// Read as a robot's model is, so that these bounds are asked for before MuJoCo is.
std::string ErrorOf(const std::string& elements) {
  const TempFolder folder;
  const auto file = folder.Write("a.xml", "<mujoco>\n" + elements + "</mujoco>");
  return folder.ErrorOf([&] { ReadMjcfNames(file); });
}

TEST(MjcfSizesTest, ALineCantAskForGigabytes) {
  EXPECT_EQ(ErrorOf("<asset><hfield name='h' nrow='30000' ncol='2' size='1 1 1 1'/></asset>"),
            "a.xml:2:8: error: <hfield> has nrow = '30000', more than a robot's 2000");
  EXPECT_EQ(ErrorOf("<asset><texture builtin='flat' width='30000' height='30000'/></asset>"),
            "a.xml:2:8: error: <texture> has width = '30000', more than a robot's 8192");
  EXPECT_EQ(ErrorOf("<size nkey='100000000'/>"),
            "a.xml:2:1: error: <size> has nkey = '100000000', more than a robot's 5000");
  EXPECT_EQ(ErrorOf("<worldbody><body><composite type='box' count='60 60 60' spacing='1'/></body>"),
            "a.xml:2:18: error: <composite> has count = '60 60 60', more than a robot's 500");
}

TEST(MjcfSizesTest, NeitherBlanksNorEntitiesHideASize) {
  const std::string what = "a.xml:2:1: error: <size> has njmax = '";
  EXPECT_EQ(ErrorOf("<size\n\tnjmax = \"1e9\" />"), what + "1e9', more than a robot's 5000");
  EXPECT_EQ(ErrorOf("<size\fnjmax\v='1e9'/>"), what + "1e9', more than a robot's 5000");
  EXPECT_EQ(ErrorOf("<size a='>' njmax='&#57;99999'/>"),
            what + "999999', more than a robot's 5000");
  EXPECT_EQ(ErrorOf("<size njmax='&#x100000000000000039;'/>"),
            what + "&#x100000000000000039;', more than a robot's 5000");
}

TEST(MjcfSizesTest, JointsAreCounted) {
  std::string joints;
  for (int i = 0; i < kMaxMjcfJoints; ++i) joints += "<freejoint/>\n";
  EXPECT_EQ(ErrorOf(joints + "<joint/>\n"),
            "a.xml:802:1: error: is one joint too many: an MJCF may have 800, with the files that "
            "it includes");
}

TEST(MjcfSizesTest, WhatARobotHasPasses) {
  for (const char* text :
       {"<mujoco><size njmax='2000' nconmax='500' nstack='1000000'/> <!-- <size nkey='1e9'> "
        "--><asset><texture builtin='flat' width='512' height='3072'/></asset>",
        "<size njmax='&#57;9'/>", "<", "<size", "<size njmax", "<size njmax=", "<size njmax='",
        "</", "<a =/="}) {
    XmlTags tags("a.xml", text);
    MjcfSizes sizes;
    while (const auto tag = tags.Next()) sizes.Check(tags, *tag);
  }
}

}  // namespace
}  // namespace sidestep::mjcf_sizes_test
