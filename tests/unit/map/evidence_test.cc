// SPDX-License-Identifier: BSD-3-Clause
#include "sim/map/evidence.h"

#include <gtest/gtest.h>

#include "models/support/config_error.h"
#include "sim/map/map_page.h"
#include "sim/record/run_summary.h"
#include "tests/support/temp_folder.h"
#include "tests/unit/map/made_map.h"

namespace sidestep::map {
namespace {

// `ours` survives 1, 2, 3 and 0 of 3; the third has lost nothing. `fixed` 0, 2, 1, 1.
TEST(WorstPointsTest, AreOfEachControllerTheLeastLimitsWithTheirSmallestLostPush) {
  const SweepMap map = MadeMap();
  const std::vector<WorstPoint> worst = WorstPoints(map, 2);
  ASSERT_EQ(worst.size(), 4U);
  const auto tell = [&](std::size_t i) {
    const MapCell& cell = map.cells[worst[i].cell];
    return map.controllers[cell.controller] + " " + std::to_string(worst[i].point->ray) + " " +
           worst[i].point->strength;
  };
  EXPECT_EQ(tell(0), "ours 3 1");
  EXPECT_EQ(tell(1), "ours 0 2");
  EXPECT_EQ(tell(2), "fixed 4 1");
  EXPECT_EQ(tell(3), "fixed 6 2");
  EXPECT_EQ(WorstPoints(map, 9).size(), 7U) << "one has lost nothing";
  EXPECT_TRUE(WorstPoints(map, 0).empty());
}

std::string SummaryOf(VerdictClass verdict, bool has_recovered) {
  RunSummary summary;
  summary.verdict = verdict;
  summary.metrics["recovered"] = has_recovered;
  return SummaryJson(summary);
}

TEST(EvidenceTest, ARunThatComesOutOtherwiseThanItsRowIsToldOf) {
  const TempFolder folder;
  folder.Write("lost/summary.json", SummaryOf(VerdictClass::kPass, false));
  folder.Write("lost/plots/com.svg", "");
  folder.Write("lost/video.mp4", "");
  folder.Write("survived/summary.json", SummaryOf(VerdictClass::kFail, true));
  folder.Write("invalid/summary.json", SummaryOf(VerdictClass::kInvalid, false));
  const auto read = [&](const char* name) {
    return ReadEvidence(folder.path() / name, CellOutcome::kLost);
  };
  const CellEvidence lost = read("lost");
  EXPECT_EQ(lost.note, "") << "whatever its scenario expects";
  EXPECT_TRUE(lost.has_video);
  EXPECT_EQ(lost.plots, std::vector<std::string>{"plots/com.svg"});
  EXPECT_EQ(read("survived").note, "run again it came out RECOVERED, the row says LOST");
  EXPECT_EQ(read("invalid").note, "run again it came out INVALID, the row says LOST");
  EXPECT_THROW(read("absent"), ConfigError);
}

TEST(EvidenceTest, ThePageShowsItInItsCellsSheet) {
  SweepMap map = MadeMap();
  EXPECT_FALSE(Has(MapPage(map, {}), "Worst cells"));
  map.cells[3].evidence = {"cells/a<b", {"plots/com.svg"}, true, "odd"};
  const std::string page = MapPage(map, {});
  EXPECT_TRUE(Has(page, "<h2>Worst cells, with plots and video</h2>"));
  EXPECT_TRUE(Has(page, "src=\"cells/a&lt;b/video.mp4\""));
  EXPECT_TRUE(Has(page, "<img loading=\"lazy\" src=\"cells/a&lt;b/plots/com.svg\""));
  EXPECT_TRUE(Has(page, "; odd:"));
  EXPECT_FALSE(Has(page, "http")) << "it needs no network";
}

}  // namespace
}  // namespace sidestep::map
