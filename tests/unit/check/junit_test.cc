// SPDX-License-Identifier: BSD-3-Clause
// The JUnit report: well-formed whatever a run says.

#include "sim/check/junit.h"

#include <gtest/gtest.h>

#include <string>

namespace sidestep::junit_test {
namespace {

Outcome Make(const std::string& name, VerdictClass verdict, std::vector<std::string> reasons) {
  Outcome outcome;
  outcome.name = name;
  outcome.file = name + ".yaml";
  outcome.robot = "robot";
  outcome.run_dir = "runs/" + name;
  outcome.verdict = verdict;
  outcome.reasons = std::move(reasons);
  outcome.measured = {"fall = true (is false) missed"};
  outcome.wall_s = 1.25;
  return outcome;
}

TEST(XmlEscapeTest, MarkupBecomesReferences) {
  EXPECT_EQ(XmlEscape("<a b=\"c\">&'"), "&lt;a b=&quot;c&quot;&gt;&amp;'");
  EXPECT_EQ(XmlEscape("a\nb\tc"), "a&#10;b&#9;c");
}

TEST(XmlEscapeTest, ControlCharactersAreDropped) {
  EXPECT_EQ(XmlEscape(std::string("a\x1b[31m\x00\x08z", 9)), "a[31mz");
}

TEST(XmlEscapeTest, WellFormedUtf8Stays) {
  const std::string text = "\xC3\xA9 \xE2\x82\xAC \xF0\x9F\xA6\xBF";
  EXPECT_EQ(XmlEscape(text), text);
}

TEST(XmlEscapeTest, BytesThatAreNoUtf8AreDropped) {
  EXPECT_EQ(XmlEscape("a\xFFz"), "az");
  EXPECT_EQ(XmlEscape("a\xC0\x80z"), "az") << "overlong";
  EXPECT_EQ(XmlEscape("a\xE0\x80\x80z"), "az") << "overlong";
  EXPECT_EQ(XmlEscape("a\xED\xA0\x80z"), "az") << "surrogate";
  EXPECT_EQ(XmlEscape("a\xEF\xBF\xBFz"), "az") << "U+FFFF";
  EXPECT_EQ(XmlEscape("a\xF4\x90\x80\x80z"), "az") << "beyond U+10FFFF";
  EXPECT_EQ(XmlEscape("a\xE2\x82"), "a") << "cut short";
  EXPECT_EQ(XmlEscape("\xE2\x82<"), "&lt;") << "cut short by markup";
}

TEST(JunitTest, ThreeVerdictsGiveTheirElementsAndTotals) {
  const std::string xml = JunitXml({Make("good", VerdictClass::kPass, {}),
                                    Make("bad", VerdictClass::kFail, {"FALL at 1.000 s: low", "B"}),
                                    Make("ugly", VerdictClass::kInvalid, {"ERROR: signal <11>"})},
                                   4.5, {"2026-11-26T20:00:00", "a host"});
  // The whole document: any change of it is a change of what CI servers get.
  const std::string totals = R"(tests="3" failures="1" errors="1" time="4.500")";
  const auto out = [](const std::string& name, const std::string& reasons) {
    return "      <system-out>scenario: " + name + ".yaml&#10;run: runs/" + name + "&#10;" +
           reasons + "fall = true (is false) missed&#10;</system-out>\n    </testcase>\n";
  };
  EXPECT_EQ(xml, R"(<?xml version="1.0" encoding="UTF-8"?>
<testsuites )" + totals +
                     R"(>
  <testsuite name="sidestep" )" +
                     totals + R"( timestamp="2026-11-26T20:00:00" hostname="a host">
    <testcase name="good" classname="sidestep.robot" time="1.250">
)" + out("good", "") +
                     R"(    <testcase name="bad" classname="sidestep.robot" time="1.250">
      <failure message="FALL at 1.000 s: low" type="FALL">FALL at 1.000 s: low&#10;B&#10;</failure>
)" + out("bad", "FALL at 1.000 s: low&#10;B&#10;") +
                     R"(    <testcase name="ugly" classname="sidestep.robot" time="1.250">
      <error message="ERROR: signal &lt;11&gt;" type="ERROR">ERROR: signal &lt;11&gt;&#10;</error>
)" + out("ugly", "ERROR: signal &lt;11&gt;&#10;") +
                     R"(  </testsuite>
</testsuites>
)");
}

}  // namespace
}  // namespace sidestep::junit_test
