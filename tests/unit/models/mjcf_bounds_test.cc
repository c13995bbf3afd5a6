// SPDX-License-Identifier: BSD-3-Clause
#include "models/mjcf/mjcf_bounds.h"

#include <gtest/gtest.h>

#include "models/robot_description/mjcf_names.h"
#include "models/support/xml_bounds.h"
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
            "d.xml:1:134: error: is nested deeper than 300, with the files that include it");
  EXPECT_NE(ErrorOf(including(1, "a.xml")), "no error") << "MuJoCo tells of loops";
}

TEST_F(MjcfBoundsTest, ManyShallowFilesAreNotDeep) {
  std::string includes;
  for (int i = 0; i < 40; ++i) {
    const std::string name = std::to_string(i) + ".xml";
    folder_.Write(name, "<mujoco><default>" + Nested("default", 8, "") + "</default></mujoco>");
    includes += "<include file='" + name + "'/>";
  }
  EXPECT_EQ(ErrorOf("<mujoco>" + includes + "</mujoco>").find("nested"), std::string::npos);
}

TEST_F(MjcfBoundsTest, ElementsOfAllFilesAreCounted) {
  std::string sites;
  for (int i = 0; i < kMaxMjcfElements / 2; ++i) sites += "<site/>\n<!-- no element -->";
  folder_.Write("b.xml", "<mujoco><worldbody>" + sites + "</worldbody></mujoco>");
  const std::string too_many =
      "b.xml:2496:20: error: is one element too many: an MJCF may have 5000, with the files that "
      "it includes";
  const std::string main = "<mujoco><worldbody>" + sites + "</worldbody>";
  EXPECT_EQ(ErrorOf(main + "<include file='b.xml'/></mujoco>"), too_many);
  EXPECT_EQ(ErrorOf(main + "</mujoco>"), "no error");
}

/// All the ways to write an include that MuJoCo takes.
TEST_F(MjcfBoundsTest, NoIncludeHides) {
  folder_.Write("sub/b.xml", "<mujoco><size njmax='1e9'/></mujoco>");
  folder_.Write("sub/b\nc.xml", "<mujoco><size njmax='1e9'/></mujoco>");
  for (const char* include : {"<include file='sub/b.xml'/>", "<include file=\"sub&#47;b.xml\"/>",
                              "<include file='sub&#x2F;b.xml'/>", "<include\ffile='sub/b.xml'/>",
                              "<INCLUDE file='sub/b.xml'/>", "<include file='/sub/b.xml'/>",
                              "<include a='file=\"c.xml\"' b='>' file='sub/b.xml'/>",
                              "<include file='sub/b\r\nc.xml'/>"}) {
    const std::string error = ErrorOf("<mujoco>" + std::string(include) + "</mujoco>");
    EXPECT_NE(error.find("njmax"), std::string::npos) << include << ": " << error;
  }
  for (const char* include :
       {"< include file='sub/b.xml'/>", "<include file='sub&#x100000000000000000000002F;b.xml'/>",
        "<?a > <!-- ?><include file='sub/b.xml'/><!-- -->"}) {
    const std::string error = ErrorOf("<mujoco>" + std::string(include) + "</mujoco>");
    EXPECT_EQ(error.rfind("a.xml:1:9: error: ", 0), 0U) << include << ": " << error;
  }
}

TEST_F(MjcfBoundsTest, AFileCountsUnderEachOfItsNames) {
  std::string sites, includes;
  for (int i = 0; i < 100; ++i) sites += "<site/>";
  folder_.Write("b.xml", "<mujoco><worldbody>" + sites + "</worldbody></mujoco>");
  for (std::string name = "b.xml"; name.size() < 120; name.insert(0, "./")) {
    includes += "<include file='" + name + "'/>";
  }
  EXPECT_NE(ErrorOf("<mujoco>" + includes + "</mujoco>").find("one element too many"),
            std::string::npos);
}

TEST_F(MjcfBoundsTest, JointsOfAllFilesAreCounted) {
  std::string joints;
  for (int i = 0; i < 500; ++i) joints += "<freejoint/>\n";
  folder_.Write("b.xml", "<mujoco>" + joints + "</mujoco>");
  EXPECT_EQ(ErrorOf("<mujoco>" + joints + "<include file='b.xml'/></mujoco>"),
            "b.xml:301:1: error: is one joint too many: an MJCF may have 800, with the files that "
            "it includes");
}

TEST_F(MjcfBoundsTest, BytesOfAllFilesAreCounted) {
  const std::string comment = "<mujoco><!--" + std::string(kMaxXmlBytes / 2, ' ') + "--></mujoco>";
  folder_.Write("b.xml", comment);
  folder_.Write("c.xml", comment);
  EXPECT_EQ(ErrorOf("<mujoco>\n<include file='b.xml'/><include file='c.xml'/></mujoco>"),
            "a.xml:2:24: error: <include> of 'c.xml' is too much: an MJCF may have 64 MiB, with "
            "the files that it includes");
}

TEST_F(MjcfBoundsTest, OnlyFilesAreIncluded) {
  EXPECT_EQ(ErrorOf("<mujoco><include file='.'/></mujoco>"),
            "a.xml:1:9: error: <include> of '.', which is no file in the folder of a.xml");
  EXPECT_EQ(ErrorOf("<mujoco><include file='b.xml'/></mujoco>"),
            "a.xml:1:9: error: <include> of 'b.xml', which is no file in the folder of a.xml");
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
