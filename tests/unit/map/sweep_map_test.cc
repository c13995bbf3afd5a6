// SPDX-License-Identifier: BSD-3-Clause
#include "sim/map/sweep_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "models/support/config_error.h"
#include "tests/unit/map/made_map.h"

namespace sidestep::map {
namespace {

TEST(SweepMapTest, ReadsCellsByPanelControllerAndDirection) {
  const SweepMap map = MadeMap();
  EXPECT_EQ(map.controllers, (std::vector<std::string>{"ours", "fixed"}));
  EXPECT_EQ(map.panels, std::vector<std::string>{"at_phase mid_swing"});
  ASSERT_EQ(map.cells.size(), 8U);
  EXPECT_TRUE(map.has_limits);
  EXPECT_TRUE(HasDirections(map));
  const MapCell* cell = FindCell(map, 0, 0, "1.5707963267948966");
  ASSERT_NE(cell, nullptr);
  EXPECT_EQ(cell->points.size(), 3U);
  EXPECT_EQ(cell->points[2].reasons, "FALL at 3 s: low, very; SLIP");
}

TEST(SweepMapTest, BracketsEndWhereTheLadderDoes) {
  const SweepMap map = MadeMap();
  const CellLimit all = LimitOf(*FindCell(map, 0, 0, "3.141592653589793"));
  EXPECT_EQ(all.survived, 3.0);
  EXPECT_TRUE(std::isinf(all.lost)) << "nothing is said above the ladder";
  EXPECT_EQ(all.share, 1.0);
  const CellLimit none = LimitOf(*FindCell(map, 0, 0, "4.71238898038469"));
  EXPECT_EQ(none.survived, 0.0);
  EXPECT_EQ(none.lost, 1.0);
  EXPECT_EQ(none.share, 0.0);
}

TEST(SweepMapTest, SurvivalBeyondALossDoesNotCount) {
  const SweepMap map =
      ParseMap(std::string(kHeader) + MadeRow(0, "a", "0", "1", "RECOVERED") +
                   MadeRow(0, "a", "0", "3", "RECOVERED") + MadeRow(0, "a", "0", "2", "LOST"),
               "m", "f");
  const CellLimit limit = LimitOf(map.cells.at(0));
  EXPECT_EQ(limit.survived, 1.0);
  EXPECT_EQ(limit.lost, 2.0);
  EXPECT_NEAR(limit.share, 2.0 / 3.0, 1e-15);
}

TEST(SweepMapTest, AnAxisOfStrengthsIsALadder) {
  const std::string header =
      "ray,id,controller,pushes.0.magnitude_N,strength,stage,seed,outcome,reasons,impulse_Nspkg\n";
  const SweepMap map =
      ParseMap(header + "0,i,a,10,,single,,RECOVERED,,0.1\n" + "1,i,a,20,,single,,LOST,FALL,0.2\n",
               "m", "f");
  ASSERT_EQ(map.cells.size(), 1U);
  EXPECT_TRUE(map.has_limits);
  EXPECT_FALSE(HasDirections(map));
  EXPECT_EQ(LimitOf(map.cells[0]).survived, 0.1);
  EXPECT_EQ(LimitOf(map.cells[0]).lost, 0.2);
}

TEST(SweepMapTest, PanelsThatLookAlikeStayApart) {
  const SweepMap map = ParseMap(std::string(kHeader) + MadeRay(0, "a", "0", 1, "0.123401") +
                                    MadeRay(1, "a", "0", 2, "0.123402"),
                                "m", "f");
  ASSERT_EQ(map.cells.size(), 2U);
  EXPECT_EQ(map.panels[0], map.panels[1]) << "in short";
  EXPECT_EQ(LimitOf(map.cells[0]).survived, 1.0);
  EXPECT_EQ(LimitOf(map.cells[1]).survived, 2.0);
}

TEST(SweepMapTest, SeedsAreOnePointAndInvalidOnesSayNothing) {
  const std::string rows = std::string(kHeader) + MadeRow(0, "a", "0", "1", "RECOVERED") +
                           MadeRow(0, "a", "0", "1", "INVALID") +
                           MadeRow(1, "a", "1", "1", "INVALID") +
                           MadeRow(1, "a", "1", "nan", "INVALID");
  const SweepMap map = ParseMap(rows, "m", "f");
  ASSERT_EQ(map.cells.size(), 2U);
  EXPECT_EQ(map.cells[0].points.size(), 1U);
  EXPECT_EQ(map.cells[0].points[0].survival(), Survival::kInvalid);
  EXPECT_TRUE(std::isnan(LimitOf(map.cells[1]).survived));
  EXPECT_TRUE(std::isnan(LimitOf(map.cells[1]).share));
}

TEST(SweepMapTest, TellsWhatIsNoTable) {
  const auto error = [](const std::string& text) {
    try {
      ParseMap(text, "m", "cells.csv");
    } catch (const ConfigError& failure) {
      return std::string(failure.what());
    }
    return std::string("none");
  };
  EXPECT_EQ(error(""), "cells.csv:1: error: is no table of a sweep's cells");
  EXPECT_EQ(error("a,b\n1,2\n"), "cells.csv:1: error: is no table of a sweep's cells");
  EXPECT_EQ(error(std::string(kHeader) + "0,i\n"), "cells.csv:2: error: has 2 columns, not 12");
  EXPECT_EQ(error(std::string(kHeader) + "1e308,i,c,0,a,1,ladder,,LOST,,1,false\n"),
            "cells.csv:2: error: ray '1e308' is no number of a ray");
  EXPECT_EQ(error(kHeader), "none") << "a sweep without rows is an empty map";
}

}  // namespace
}  // namespace sidestep::map
