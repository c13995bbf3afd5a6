// SPDX-License-Identifier: BSD-3-Clause
#include "sim/scenario/yaml_writer.h"

#include <gtest/gtest.h>

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
