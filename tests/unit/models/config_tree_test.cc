// SPDX-License-Identifier: BSD-3-Clause
#include "models/support/config_tree.h"

#include <gtest/gtest.h>

#include <string>

#include "models/support/config_error.h"
#include "tests/support/temp_folder.h"

namespace sidestep::config_tree_test {
namespace {

std::string ErrorIn(const std::string& text, const ConfigSource& source = {"a.yaml", true}) {
  try {
    ParseConfig(text, source);
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "no error";
}

std::string PlaceText(const ConfigPlace& place) {
  return std::to_string(place.line) + ":" + std::to_string(place.column);
}

TEST(ConfigTreeTest, KeysAndValuesKnowTheirPlaces) {
  const ConfigTree root = ParseConfig("a: 1\nb:\n  c: [2, {d: 3}]\ne:\n", {"a.yaml", true});
  ASSERT_EQ(root.keys.size(), 3U);
  EXPECT_EQ(PlaceText(root.keys[1].place), "2:1");
  EXPECT_EQ(PlaceText(root.Find("a")->place), "1:4");
  const ConfigTree& list = *root.Find("b")->Find("c");
  EXPECT_EQ(PlaceText(list.place), "3:6");
  EXPECT_EQ(PlaceText(list.children[1].Find("d")->place), "3:14");
  EXPECT_EQ(PlaceText(root.Find("e")->place), "4:1") << "an empty value has its key's place";
}

TEST(ConfigTreeTest, TellsKindsApart) {
  const ConfigTree root = ParseConfig("{a: 1, b: '1', c: ~, d: [], e: {}}", {"a.yaml", true});
  EXPECT_EQ(root.Find("a")->kind, ConfigKind::kScalar);
  EXPECT_FALSE(root.Find("a")->is_quoted);
  EXPECT_TRUE(root.Find("b")->is_quoted);
  EXPECT_EQ(root.Find("c")->kind, ConfigKind::kNull);
  EXPECT_EQ(root.Find("d")->kind, ConfigKind::kList);
  EXPECT_EQ(root.Find("e")->kind, ConfigKind::kMap);
  EXPECT_EQ(root.Find("f"), nullptr);
}

TEST(ConfigTreeTest, RefusesADuplicateKey) {
  EXPECT_EQ(ErrorIn("a: 1\nb: {c: 1, d: 2, c: 3}\n"),
            "a.yaml:2:17: error: key 'c' appears twice; first at line 2");
  EXPECT_EQ(ErrorIn("a: 1\na: 2\n"), "a.yaml:2:1: error: key 'a' appears twice; first at line 1");
}

TEST(ConfigTreeTest, RefusesAKeyThatIsNoWord) {
  EXPECT_EQ(ErrorIn("[a, b]: 1\n"), "a.yaml:1:1: error: a key must be a word");
  EXPECT_EQ(ErrorIn("~: 1\n"), "a.yaml:1:1: error: a key must be a word");
}

TEST(ConfigTreeTest, RefusesAliases) {
  EXPECT_EQ(ErrorIn("a: &x 1\nb: *x\n"),
            "a.yaml:2:4: error: aliases ('*name') are not supported; write the value out");
}

TEST(ConfigTreeTest, RefusesTags) {
  EXPECT_EQ(ErrorIn("a: !!float 1\n"),
            "a.yaml:1:4: error: tags ('tag:yaml.org,2002:float') are not supported");
}

TEST(ConfigTreeTest, TellsThePlaceOfASyntaxError) {
  EXPECT_EQ(ErrorIn("a: 1\nb: [1, 2\n"),
            "a.yaml:3:1: error: YAML syntax: end of sequence flow not found");
  EXPECT_EQ(ErrorIn("a: 1\n\tb: 2\n"),
            "a.yaml:2:1: error: YAML syntax: illegal tab when looking for indentation");
}

TEST(ConfigTreeTest, RefusesAnEmptyText) {
  EXPECT_EQ(ErrorIn(""), "a.yaml:1:1: error: the file is empty");
  EXPECT_EQ(ErrorIn("# only a comment\n"), "a.yaml:1:1: error: the file is empty");
  EXPECT_EQ(ErrorIn("~\n"), "a.yaml:1:1: error: the file is empty");
}

TEST(ConfigTreeTest, RefusesASecondDocument) {
  EXPECT_EQ(ErrorIn("a: 1\n---\nb: 2\n"),
            "a.yaml:3:1: error: a second document begins here; one is expected");
}

TEST(ConfigTreeTest, RefusesControlCharactersThatYamlCppTakesForTheEnd) {
  EXPECT_EQ(ErrorIn("a: 1\n\x04\nb: 2\n"), "a.yaml:2:1: error: control character 0x04");
}

TEST(ConfigTreeTest, RefusesAbysmalNesting) {
  const auto nested = [](std::size_t levels) {
    return std::string(levels, '[') + std::string(levels, ']');
  };
  EXPECT_EQ(ErrorIn(nested(32)), "no error");
  EXPECT_EQ(ErrorIn(nested(33)), "a.yaml:1:33: error: is nested too deeply");
  EXPECT_NE(ErrorIn(std::string(100000, '[')), "no error");
}

TEST(ConfigTreeTest, RefusesMapsOfVeryManyKeys) {
  const auto keys = [](int count) {
    std::string text;
    for (int i = 0; i < count; ++i) text += "k" + std::to_string(i) + ": {a: 1, b: 2}\n";
    return text;
  };
  EXPECT_EQ(ErrorIn(keys(1000)), "no error");
  EXPECT_EQ(ErrorIn(keys(90'000)),
            "a.yaml:1001:1: error: is one key too many: a map has at most 1000");
}

TEST(ConfigTreeTest, KindsOfFilesAreToldByAKey) {
  const TempFolder folder;
  EXPECT_TRUE(IsConfigFileWith("kind", folder.Write("a.yaml", "{name: x, kind: 1}")));
  EXPECT_FALSE(IsConfigFileWith("kind", folder.Write("b.yaml", "{name: kind, inner: {kind: 1}}")));
  EXPECT_FALSE(IsConfigFileWith("kind", folder.Write("c.yaml", "[kind]")));
  EXPECT_FALSE(IsConfigFileWith("kind", folder.Write("d.yaml", "kind: [")));
  EXPECT_FALSE(IsConfigFileWith("kind", folder.path()));
  EXPECT_FALSE(IsConfigFileWith("kind", folder.path() / "gone.yaml"));
}

TEST(ConfigTreeTest, ErrorsInAnOptionTellTheColumnOfTheValue) {
  const ConfigSource option{"--set a={b: 1, b: 2}", false};
  EXPECT_EQ(ErrorIn("{b: 1, b: 2}", option),
            "--set a={b: 1, b: 2}: error: key 'b' appears twice; first at line 1 "
            "(column 8 of the value)");
  EXPECT_EQ(ErrorIn("", {"--set a=", false}), "--set a=: error: the value is empty");
}

}  // namespace
}  // namespace sidestep::config_tree_test
