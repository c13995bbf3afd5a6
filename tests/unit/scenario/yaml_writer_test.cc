// SPDX-License-Identifier: BSD-3-Clause
#include "sim/scenario/yaml_writer.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <regex>
#include <string>

#include "models/support/config_tree.h"

namespace sidestep::yaml_writer_test {
namespace {

TEST(YamlWriterTest, PlainWordsStayPlain) {
  EXPECT_EQ(YamlScalar("left_foot"), "left_foot");
  EXPECT_EQ(YamlScalar("/a/b-c.yaml"), "/a/b-c.yaml");
}

TEST(YamlWriterTest, WordsThatMeanSomethingElseAreQuoted) {
  for (const char* word : {"null", "True", "no", "~", "1e5", "0.1", "", "-a", "a b"}) {
    EXPECT_EQ(YamlScalar(word), "\"" + std::string(word) + "\"");
  }
}

TEST(YamlWriterTest, EveryTextReadsBack) {
  std::string all;
  for (int code = 1; code < 0x80; ++code) all += static_cast<char>(code);
  const std::vector<std::string> texts{all,
                                       "a: b # c",
                                       "\"quoted\" 'twice'",
                                       "back\\slash",
                                       " space",
                                       "\xC3\xA9 \xE2\x80\xA8 \xC2\x85",
                                       "{[,]}&*!|>%@`",
                                       "tab\tline\nreturn\rend"};
  for (const std::string& text : texts) {
    const ConfigTree root = ParseConfig("key: " + YamlScalar(text) + "\n", {"a.yaml", true});
    EXPECT_EQ(root.Find("key")->scalar, text);
  }
}

TEST(YamlWriterTest, NumbersAreFloatsOfYaml11AsWell) {
  // Its floats have a point; 1e-06 would be text to its readers.
  const std::regex yaml_float(R"([-+]?[0-9]+(\.[0-9]*([eE][-+][0-9]+)?)?)");
  for (const double value : {1e-6, -1e-6, 2e-17, 1.5e-7, 1e23, 1e300, 5e-324, 0.1, 3.0, -0.0}) {
    const std::string text = YamlNumber(value);
    EXPECT_TRUE(std::regex_match(text, yaml_float)) << text;
    EXPECT_EQ(ParseConfig("key: " + text + "\n", {"a.yaml", true}).Find("key")->scalar, text);
    EXPECT_EQ(std::strtod(text.c_str(), nullptr), value);
  }
  EXPECT_EQ(YamlNumber(1e-6), "1.0e-06");
  EXPECT_EQ(YamlNumber(1.5e-7), "1.5e-07");
  EXPECT_EQ(YamlVector({1e-6, 0.5, 2e9}), "[1.0e-06, 0.5, 2.0e+09]");
}

struct Inner {
  bool flag{true};
  int count{3};
  template <typename Self, typename Visitor>
  static void VisitFields(Self& self, Visitor&& visit) {
    visit("flag", self.flag, "");
    visit("count", self.count, Range{0, 10}, "");
  }
};

struct Outer {
  double time_s{0.1};
  Eigen::Vector3d point_m{1, -2, 0.5};
  std::string name{"a b"};
  Inner inner;
  template <typename Self, typename Visitor>
  static void VisitFields(Self& self, Visitor&& visit) {
    visit("time_s", self.time_s, Range{0, 1}, "");
    visit("point_m", self.point_m, Range{-5, 5}, "");
    visit("name", self.name, "");
    visit("inner", self.inner, "");
  }
};

TEST(YamlWriterTest, WritesFieldsOfEveryTypeAndListsOfMaps) {
  YamlWriter yaml;
  yaml.Begin("list");
  for (int i = 0; i < 2; ++i) {
    yaml.BeginElement();
    yaml.Fields(Inner{i == 0, i});
    yaml.EndElement();
  }
  yaml.End();
  yaml("outer", Outer(), "");
  EXPECT_EQ(yaml.text(),
            "list:\n"
            "  - flag: true\n"
            "    count: 0\n"
            "  - flag: false\n"
            "    count: 1\n"
            "outer:\n"
            "  time_s: 0.1\n"
            "  point_m: [1, -2, 0.5]\n"
            "  name: \"a b\"\n"
            "  inner:\n"
            "    flag: true\n"
            "    count: 3\n");
}

}  // namespace
}  // namespace sidestep::yaml_writer_test
