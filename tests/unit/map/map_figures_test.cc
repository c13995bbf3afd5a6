// SPDX-License-Identifier: BSD-3-Clause
#include "sim/map/map_figures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/unit/map/made_map.h"

namespace sidestep::map {
namespace {

constexpr double kPi = std::numbers::pi;

TEST(MapFiguresTest, AreThoseWorkedByHand) {
  SweepMap map = MadeMap();
  for (MapCell& cell : map.cells) cell.physical_Nspkg = 4.0;
  const std::vector<ControllerFigures> all = FiguresOf(map);
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].controller, "ours");
  EXPECT_EQ(all[0].runs, 12);
  EXPECT_EQ(all[0].recovered, 6);
  EXPECT_EQ(all[0].lost, 6);
  EXPECT_EQ(all[0].least, 0.0);
  EXPECT_EQ(all[0].worst->direction, "4.71238898038469");
  EXPECT_EQ(all[0].mean, 1.5);
  EXPECT_EQ(all[0].most, 3.0);
  // Quarter turns: pi/4 (1 + 4 + 9 + 0).
  EXPECT_NEAR(all[0].area, 0.25 * kPi * 14.0, 1e-12);
  EXPECT_NEAR(all[0].physical_share, 1.5 / 4.0, 1e-15);
  EXPECT_EQ(all[1].mean, 1.0);
  EXPECT_NEAR(all[1].area, 0.25 * kPi * 6.0, 1e-12);
}

TEST(MapFiguresTest, ACircleOfDirectionsHasItsArea) {
  std::vector<std::pair<double, double>> rays;
  for (int i = 0; i < 16; ++i) rays.emplace_back(-kPi + i * kPi / 8.0, 2.0);
  EXPECT_NEAR(SectorArea(rays), 4.0 * kPi, 1e-12);
  rays.resize(8);
  EXPECT_TRUE(std::isnan(SectorArea(rays))) << "half a turn is no area";
}

TEST(MapFiguresTest, NothingToTellIsNaNAndNoCrash) {
  const SweepMap empty = ParseMap(kHeader, "m", "f");
  EXPECT_TRUE(FiguresOf(empty).empty());
  const SweepMap invalid =
      ParseMap(std::string(kHeader) + MadeRow(0, "a", "0", "1", "INVALID"), "m", "f");
  const ControllerFigures figures = FiguresOf(invalid).at(0);
  EXPECT_EQ(figures.cells, 0);
  EXPECT_EQ(figures.invalid, 1);
  EXPECT_EQ(figures.worst, nullptr);
  EXPECT_TRUE(std::isnan(figures.mean));
}

TEST(MapFiguresTest, DimensionlessIsImpulseTimesOmegaOverWeight) {
  SweepMap map;
  EXPECT_TRUE(std::isnan(Dimensionless(map, 1.0)));
  map.omega_per_s = 9.81;
  EXPECT_NEAR(Dimensionless(map, 0.5), 0.5, 1e-9);
}

TEST(MapFiguresTest, OnlyBracketsThatAreApartDecide) {
  const SweepMap map = MadeMap();
  const auto contest = [&](const char* direction) {
    return Compare(map, *FindCell(map, 0, 0, direction), *FindCell(map, 1, 0, direction));
  };
  EXPECT_EQ(contest("0"), Contest::kFirst) << "survived 1 where the other was lost at 1";
  EXPECT_EQ(contest("1.5707963267948966"), Contest::kOpen);
  EXPECT_EQ(contest("3.141592653589793"), Contest::kFirst);
  EXPECT_EQ(contest("4.71238898038469"), Contest::kSecond);
}

}  // namespace
}  // namespace sidestep::map
