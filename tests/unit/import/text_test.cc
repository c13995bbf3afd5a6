// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/text.h"

#include <gtest/gtest.h>

#include "models/import/write_robot_yaml.h"

namespace sidestep::importer {
namespace {

TEST(Text, FiguresAreShort) {
  EXPECT_EQ(Figure(0.1 + 0.2), "0.3");
  EXPECT_EQ(Figure(12000.0), "12000");
  EXPECT_EQ(Figure(-0.0), "0");
  EXPECT_EQ(Figure(123456.0), "123500");
  EXPECT_EQ(Figure(1e9), "1000000000");
  EXPECT_EQ(Figure(1.23456789e-7), "1.235e-07");
  EXPECT_EQ(Figure(3.14159265358979, 12), "3.14159265359");
}

TEST(Text, ListsAreShort) {
  EXPECT_EQ(Listed({"a"}), "'a'");
  EXPECT_EQ(Listed({"a", "b", "c"}), "'a', 'b' and 'c'");
  EXPECT_EQ(Listed({"a", "b", "c", "d", "e", "f", "g"}), "'a', 'b', 'c', 'd' and 3 more");
}

TEST(Text, EscapesWhatAFormatReserves) {
  EXPECT_EQ(XmlEscaped("a<b>&\"c\""), "a&lt;b&gt;&amp;&quot;c&quot;");
  EXPECT_EQ(YamlText("left_foot"), "left_foot");
  EXPECT_EQ(YamlText("yes"), "'yes'");
  EXPECT_EQ(YamlText("12"), "'12'");
  EXPECT_EQ(YamlText("it's: [odd"), "'it''s: [odd'");
}

}  // namespace
}  // namespace sidestep::importer
