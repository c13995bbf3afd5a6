// SPDX-License-Identifier: BSD-3-Clause
#include "sim/scenario/key_text.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <set>

#include "models/support/config_error.h"
#include "sim/scenario/key_table.h"
#include "sim/verdict/metrics.h"

namespace sidestep::key_text_test {
namespace {

std::string TextOf(const std::string& file) {
  std::ifstream in(std::string(SIDESTEP_SOURCE_DIR) + "/" + file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// What stands between `<!-- NAME -->` and `<!-- end of NAME -->`.
std::string Between(const std::string& text, const std::string& name) {
  const std::string begin = "<!-- " + name + " -->\n", end = "<!-- end of " + name + " -->";
  const std::size_t from = text.find(begin), to = text.find(end);
  if (from == std::string::npos || to == std::string::npos) return "no such markers: " + name;
  return text.substr(from + begin.size(), to - from - begin.size());
}

std::string ErrorOfPrefix(const std::string& prefix) {
  try {
    KeysText(prefix);
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "no error";
}

TEST(KeyTextTest, TellsUnitRangeDefaultAndMeaning) {
  EXPECT_EQ(KeysText("world"),
            "KEY                      UNIT  RANGE          DEFAULT   MEANING\n"
            "world                                                   the simulated world\n"
            "world.friction                 0 to 10        0.8       sliding coefficient between "
            "foot and floor\n"
            "world.step_s             s     1e-05 to 0.02  0.001     one physics step\n"
            "world.mass_scale               0.5 to 2       1         every mass and inertia of the "
            "plant over what the controller takes it for\n"
            "world.ground                                            patches of the ground that "
            "are not level with the rest\n"
            "world.ground[].from_x_m  m     -100 to 100    required  where it begins; the robot "
            "starts at 0\n"
            "world.ground[].to_x_m    m     -100 to 100    required  where it ends\n"
            "world.ground[].from_y_m  m     -100 to 100    -100      its right side\n"
            "world.ground[].to_y_m    m     -100 to 100    100       its left side\n"
            "world.ground[].height_m  m     -0.5 to 0.5    required  over the rest of the ground; "
            "negative: a hole\n");
}

TEST(KeyTextTest, OneKeyIsOneRow) {
  EXPECT_EQ(KeysText("pushes[].duration_s"),
            "KEY                  UNIT  RANGE             DEFAULT   MEANING\n"
            "pushes[].duration_s  s     above 0 to 10000  required  how long it lasts\n");
  EXPECT_EQ(KeysText("pushes.0.duration_s"), KeysText("pushes[].duration_s"));
  EXPECT_NE(KeysText("control.mode").find("torque, position, passive  torque   torque: inverse"),
            std::string::npos);
  EXPECT_NE(KeysText("video.size").find("each 64 to 4096  [640, 480]  [width, height]"),
            std::string::npos);
}

TEST(KeyTextTest, AnUnknownPrefixNamesTheNearestKey) {
  EXPECT_EQ(ErrorOfPrefix("control.mcp"),
            "error: control.mcp is not a known key; did you mean 'mpc'?");
  EXPECT_EQ(ErrorOfPrefix("contrl.mpc"),
            "error: contrl is not a known key; did you mean 'control'?");
  EXPECT_EQ(ErrorOfPrefix("world.colour"),
            "error: world.colour is not a known key; known keys: friction, step_s, mass_scale, "
            "ground");
  EXPECT_EQ(ErrorOfPrefix("world.0"),
            "error: world.0 is not a known key; known keys: friction, step_s, mass_scale, ground")
      << "only lists have elements";
  EXPECT_EQ(ErrorOfPrefix("seed.low"), "error: seed.low is not a known key; known keys: none");
}

void CollectMeanings(const KeyInfo& key, const std::string& path, std::set<std::string>* meanings) {
  EXPECT_FALSE(key.meaning.empty()) << path;
  EXPECT_EQ(key.meaning.find_first_of("\n|"), std::string::npos) << path << ": one table cell";
  EXPECT_NE(key.meaning.back(), '.') << path;
  meanings->insert(key.meaning);
  for (const KeyInfo& child : key.children) {
    CollectMeanings(child, KeyPath(path, key, child), meanings);
  }
}

TEST(KeyTextTest, EveryKeyHasAMeaningOfOneLine) {
  std::set<std::string> meanings;
  CollectMeanings(ScenarioKeys(), "", &meanings);
  EXPECT_GT(meanings.size(), 100U) << "of their own";
}

TEST(KeyTextTest, MetricsAreAllListed) {
  for (const MetricInfo& metric : KnownMetrics()) {
    EXPECT_NE(MetricsText().find("\n" + std::string(metric.name) + " "), std::string::npos);
  }
  EXPECT_NE(MetricsText().find("J         integral of the absolute power of the actuators\n"),
            std::string::npos);
}

// Mend by putting what `sidestep keys --markdown` (or `metrics`) prints between the markers.
TEST(KeyTextTest, TheReferenceIsWhatTheProgramSays) {
  const std::string text = TextOf("scenarios/README.md");
  EXPECT_TRUE(Between(text, "sidestep keys --markdown") == KeysMarkdown(""));
  EXPECT_TRUE(Between(text, "sidestep metrics --markdown") == MetricsMarkdown());
}

// Keys named in the README's own table: the first cell of each row, `a.b` or a `c` that goes on in
// the map of the one before.
TEST(KeyTextTest, TheReadmeNamesKeysThatExist) {
  const KeyInfo root = ScenarioKeys();
  std::string table = Between(TextOf("README.md"), "main keys");
  int names = 0;
  for (std::size_t row = table.find("\n| `"); row != std::string::npos;
       row = table.find("\n| `", row + 1)) {
    const std::string cell = table.substr(row, table.find(" |", row + 2) - row);
    std::string map;
    for (std::size_t from = cell.find('`'); from != std::string::npos;) {
      const std::size_t to = cell.find('`', from + 1);
      std::string name = cell.substr(from + 1, to - from - 1);
      from = cell.find('`', to + 1);
      if (name.ends_with(".*")) name.resize(name.size() - 2);
      if (name.find('.') == std::string::npos) name = map + name;
      map = name.find('.') == std::string::npos ? "" : name.substr(0, name.rfind('.') + 1);
      EXPECT_NO_THROW(FindKey(root, name)) << name;
      ++names;
    }
  }
  EXPECT_GT(names, 30);
}

}  // namespace
}  // namespace sidestep::key_text_test
