// SPDX-License-Identifier: BSD-3-Clause
#include "sim/render/caption.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "sim/palette/palette.h"

namespace sidestep::render::caption_test {
namespace {

RunSummary FailedRun() {
  RunSummary summary;
  summary.name = "push_left";
  summary.verdict = VerdictClass::kFail;
  summary.reasons = {{"FALL", "base below half its height", 3.25}};
  summary.pushes.resize(1);
  summary.pushes[0].body = "r_hand";
  summary.pushes[0].start_s = 1.0;
  summary.pushes[0].duration_s = 0.5;
  return summary;
}

StateRow RowAtTime(double time_s, double force_N = 0.0) {
  StateRow row;
  row.time_s = time_s;
  row.push_force_W << 0.0, force_N, 0.0;
  row.push_point_W.setZero();
  return row;
}

bool Says(const std::vector<Caption>& captions, const std::string& text) {
  for (const Caption& caption : captions) {
    if (caption.text.find(text) != std::string::npos) return true;
  }
  return false;
}

TEST(CaptionTest, APushIsNamedWithItsForceAndBodyWhileItActs) {
  EXPECT_TRUE(Says(CaptionsAt(RowAtTime(1.2, 40.0), 4.0, FailedRun()), "PUSH 40 N on r_hand"));
  EXPECT_TRUE(Says(CaptionsAt(RowAtTime(1.6), 4.0, FailedRun()), "no push"));
}

TEST(CaptionTest, NameTimeAndVerdictAreAlwaysThere) {
  const auto captions = CaptionsAt(RowAtTime(0.5), 4.0, FailedRun());
  EXPECT_TRUE(Says(captions, "push_left"));
  EXPECT_TRUE(Says(captions, "0.50 s / 4.00 s"));
  EXPECT_TRUE(Says(captions, "FAIL FALL"));
  for (const Caption& caption : captions) EXPECT_FALSE(caption.is_big);
}

TEST(CaptionTest, TheLastSecondShowsTheVerdictBigWithItsReason) {
  const auto captions = CaptionsAt(RowAtTime(3.5), 4.0, FailedRun());
  EXPECT_TRUE(Says(captions, "FALL: base below half its height at 3.25 s"));
  EXPECT_EQ(std::count_if(captions.begin(), captions.end(),
                          [](const Caption& caption) { return caption.is_big; }),
            1);
}

TEST(CaptionTest, AFallThatWasExpectedIsToldBesideThePass) {
  RunSummary summary;
  summary.verdict = VerdictClass::kPass;
  summary.metrics = {{"fall", true}};
  const auto captions = CaptionsAt(RowAtTime(3.5), 4.0, summary);
  EXPECT_TRUE(Says(captions, "FELL"));
  EXPECT_TRUE(Says(captions, "as expected: PASS"));
  summary.metrics = {{"fall", false}};
  EXPECT_FALSE(Says(CaptionsAt(RowAtTime(3.5), 4.0, summary), "FELL"));
}

TEST(CaptionTest, ASummaryWithoutAnythingIsNoError) {
  const auto captions = CaptionsAt(RowAtTime(0.5, 12.0), 4.0, RunSummary());
  EXPECT_TRUE(Says(captions, "PUSH 12 N"));
}

TEST(CaptionTest, TextThatTheFontLacksIsReplacedAndLongTextCut) {
  EXPECT_EQ(Printable("a\tb\xC3\xA9", 10), "a?b??");
  EXPECT_EQ(Printable("abcdefghij", 6), "abcd..");
}

TEST(CaptionTest, TheLegendTellsTheColoursThatPlotsHaveToo) {
  const auto legend = LegendAt(RowAtTime(1.0), 4.0, FailedRun(), {"left", "right"});
  ASSERT_EQ(legend.size(), 5U);
  EXPECT_TRUE(Says(legend, "push"));
  EXPECT_TRUE(Says(legend, "right: foothold, force"));
  const std::array<float, 3> right = palette::Channels(palette::Foot(1));
  ASSERT_TRUE(legend[2].swatch.has_value());
  EXPECT_TRUE(legend[2].swatch->isApprox(Eigen::Vector3f(right[0], right[1], right[2])));
  RunSummary unpushed = FailedRun();
  unpushed.pushes.clear();
  EXPECT_FALSE(Says(LegendAt(RowAtTime(1.0), 4.0, unpushed, {"left"}), "push"));
  EXPECT_TRUE(LegendAt(RowAtTime(3.5), 4.0, FailedRun(), {"left"}).empty()) << "the verdict's";
}

TEST(CaptionTest, ASlowFilmTellsItsSpeed) {
  EXPECT_TRUE(Says(CaptionsAt(RowAtTime(0.5), 4.0, FailedRun(), 0.25), "0.50 s / 4.00 s, 0.25x"));
  EXPECT_FALSE(Says(CaptionsAt(RowAtTime(0.5), 4.0, FailedRun(), 1.0), "s, "));
}

}  // namespace
}  // namespace sidestep::render::caption_test
