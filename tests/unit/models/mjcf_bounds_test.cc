// SPDX-License-Identifier: BSD-3-Clause
#include "models/mjcf/mjcf_bounds.h"

#include <gtest/gtest.h>

#include "models/robot_description/mjcf_names.h"
#include "tests/support/temp_folder.h"

namespace sidestep::mjcf_bounds_test {
namespace {

/// `inner` within that many elements.
std::string Nested(const std::string& tag, int depth, const std::string& inner) {
  std::string text = inner;
  for (int i = 0; i < depth; ++i) text = "<" + tag + ">" + text + "</" + tag + ">";
  return text;
}

class MjcfBoundsTest : public testing::Test {
 protected:
  std::string ErrorOf(const std::string& text) const {
    const auto file = folder_.Write("a.xml", text);
    return folder_.ErrorOf([&] { ReadMjcfNames(file); });
  }

  const TempFolder folder_;
};

TEST_F(MjcfBoundsTest, NestingEndsInOneLine) {
  std::string deep = "<mujoco><worldbody>";
  for (int i = 0; i < 100'000; ++i) deep += "<body>";
  EXPECT_EQ(ErrorOf(deep), "a.xml:1:608: error: has elements nested deeper than 100");
}

TEST_F(MjcfBoundsTest, FilesWithinEachOtherAddUp) {
  const auto including = [](int depth, const std::string& file) {
    return "<mujoco><worldbody>" + Nested("body", depth, "<include\n file = '" + file + "'/>") +
           "</worldbody></mujoco>";
  };
  folder_.Write("b.xml", including(90, "c.xml"));
  folder_.Write("c.xml", including(90, "d.xml"));
  folder_.Write("d.xml", including(90, "a.xml"));
  EXPECT_EQ(ErrorOf(including(90, "b.xml")),
            "a.xml: error: has elements nested deeper than 300, with the files that it includes");
  EXPECT_NE(ErrorOf(including(1, "a.xml")), "no error") << "MuJoCo tells of loops";
}

TEST_F(MjcfBoundsTest, ElementsOfAllFilesAreCounted) {
  std::string sites;
  for (int i = 0; i < kMaxMjcfElements / 2; ++i) sites += "<site/>\n<!-- no element -->";
  folder_.Write("b.xml", "<mujoco><worldbody>" + sites + "</worldbody></mujoco>");
  EXPECT_EQ(ErrorOf("<mujoco><worldbody>" + sites + "</worldbody><include file='b.xml'/></mujoco>"),
            "a.xml: error: has more than 5000 elements, with the files that it includes");
  EXPECT_EQ(ErrorOf("<mujoco><worldbody>" + sites + "</worldbody></mujoco>"), "no error");
}

TEST_F(MjcfBoundsTest, NamesArePlainWords) {
  const std::string geom = "<geom size='0.1'/>";
  EXPECT_EQ(ErrorOf("<mujoco><worldbody><body name='a b'><joint name='c;d'/>" + geom +
                    "</body></worldbody></mujoco>"),
            "a.xml: error: body 'a b': a name must be 1 to 100 letters, digits, '_', '-' or '.', "
            "and begin with neither '-' nor '.'\n"
            "a.xml: error: joint 'c;d': a name must be 1 to 100 letters, digits, '_', '-' or '.', "
            "and begin with neither '-' nor '.'");
}

}  // namespace
}  // namespace sidestep::mjcf_bounds_test
