// SPDX-License-Identifier: BSD-3-Clause
#include "sim/map/compare_maps.h"

#include <gtest/gtest.h>

#include <string>

#include "tests/unit/map/made_map.h"

namespace sidestep::map {
namespace {

SweepMap Of(const std::string& rows) { return ParseMap(kHeader + rows, "m", "f"); }

TEST(CompareMapsTest, CountsCellsWonAndLost) {
  const SweepMap before = Of(MadeRay(0, "a", "0", 1) + MadeRay(1, "a", "1", 2) +
                             MadeRay(2, "a", "2", 2) + MadeRow(3, "a", "3", "1", "INVALID"));
  const SweepMap after =
      Of(MadeRay(0, "a", "0", 2) + MadeRay(1, "a", "1", 0) + MadeRay(2, "a", "2", 2) +
         MadeRay(3, "a", "3", 1) + MadeRay(4, "a", "4", 1));
  const MapComparison comparison = CompareMaps(before, after);
  EXPECT_EQ(comparison.won, 1);
  EXPECT_EQ(comparison.lost, 1);
  EXPECT_EQ(comparison.open, 1);
  EXPECT_EQ(comparison.unknown, 1);
  EXPECT_EQ(comparison.only_first, 0U);
  EXPECT_EQ(comparison.only_second, 1U);
  const std::string text = ComparisonText(comparison);
  EXPECT_NE(text.find("  won   a, at_phase mid_swing, 0 deg: [1, 2) 33.3 % -> [2, 3) 66.7 %\n"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("B against A: 1 cells won, 1 lost, 1 undecided, 1 INVALID; 1 cells are in "
                      "one map only\n"),
            std::string::npos)
      << text;
}

TEST(CompareMapsTest, SingleControllersAreComparedWhateverTheirNames) {
  const SweepMap a = Of(MadeRay(0, "old", "0", 1)), b = Of(MadeRay(0, "new", "0", 3));
  EXPECT_EQ(CompareMaps(a, b).won, 1);
  EXPECT_EQ(CompareMaps(b, a).lost, 1);
  const SweepMap two = Of(MadeRay(0, "x", "0", 1) + MadeRay(1, "y", "0", 1));
  EXPECT_EQ(CompareMaps(a, two).only_first, 1U);
}

TEST(CompareMapsTest, QuantitiesAreByName) {
  const SweepMap map = MadeMap();
  const std::vector<Quantity> all = QuantitiesOf(CompareMaps(map, map));
  ASSERT_EQ(all.size(), 10U);
  EXPECT_EQ(all[0].name, "won");
  EXPECT_EQ(all[0].second, 0.0);
  EXPECT_EQ(all[5].name, "ours.mean");
  EXPECT_EQ(all[5].first, 1.5);
}

}  // namespace
}  // namespace sidestep::map
