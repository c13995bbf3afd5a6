// SPDX-License-Identifier: BSD-3-Clause
#include "sim/limit/limit_table.h"

#include <gtest/gtest.h>

#include <numbers>
#include <string>

namespace sidestep::limit::limit_table_test {
namespace {

// Two moments, two directions; 9.81 / 4.905 makes dimensionless figures half.
LimitTable Table() {
  LimitTable table;
  table.subject = "walker";
  table.task.params.omega_per_s = 4.905;
  table.task.moments = {{"lift_off", 0.0}, {"mid_swing", 0.2}};
  table.task.directions_rad = {0.0, std::numbers::pi / 2};
  table.push_s = 0.1;
  table.limits = {{1.0, 0.5}, {2.0, 0.7}};
  return table;
}

TEST(LimitTableTest, CsvHasARowAMomentAndDirection) {
  EXPECT_EQ(LimitCsv(Table()),
            "moment,time_s,direction_rad,limit_Ns_per_kg,limit_ratio\n"
            "lift_off,0.0000,0.00000,1.0000,0.5000\n"
            "lift_off,0.0000,1.57080,0.5000,0.2500\n"
            "mid_swing,0.2000,0.00000,2.0000,1.0000\n"
            "mid_swing,0.2000,1.57080,0.7000,0.3500\n");
}

TEST(LimitTableTest, TextHasWhatWasAssumedAndLeastAndMean) {
  const std::string text = LimitText(Table());
  EXPECT_EQ(text.rfind("walker: walk, steps free, push of 0.1 s at the CoM", 0), 0U) << text;
  EXPECT_NE(text.find(" swing_speed_mps=2"), std::string::npos) << text;
  EXPECT_EQ(text.find("flight_s"), std::string::npos) << "of a hop: " << text;
  EXPECT_NE(text.find("mid_swing    0.200  2.00  0.70    0.70  1.35\n"), std::string::npos) << text;
  EXPECT_NE(text.find("all: min 0.50, mean 1.05 N s/kg; over m g / omega: min 0.250, mean 0.525"),
            std::string::npos)
      << text;
}

TEST(LimitTableTest, APushAboveTheComCountsMoreIfTheFeetBearItsSpin) {
  // By hand: at 1.25 times the CoM's height a push is worth 1.25 of one there; below, less.
  EXPECT_DOUBLE_EQ(SharesOf({"chest", 1.25}).least, 0.8);
  EXPECT_DOUBLE_EQ(SharesOf({"chest", 1.25}).most, 1.0);
  EXPECT_DOUBLE_EQ(SharesOf({"knee", 0.5}).least, 1.0);
  EXPECT_DOUBLE_EQ(SharesOf({"knee", 0.5}).most, 2.0);
  LimitTable table = Table();
  table.part = PushedPart{"chest", 1.25};
  EXPECT_NE(LimitCsv(table).find(",0.5000,0.8000,1.0000\n"), std::string::npos) << LimitCsv(table);
  EXPECT_NE(LimitText(table).find("between 0.80 and 1.00 of these, min 0.40 to 0.50"),
            std::string::npos)
      << LimitText(table);
}

TEST(LimitTableTest, ALongerPushIsWorthMoreAndAHopsIsLeftAsItIs) {
  LimitTask task;
  task.freedom = StepFreedom::kNone;
  task.moments = {{"lift_off", 0.0}};
  task.directions_rad = {0.0};
  const double instant = MakeLimitTable("a", task, 0.0, {}).limits[0][0];
  EXPECT_NEAR(MakeLimitTable("a", task, 0.1, {}).limits[0][0], 1.2275 * instant, 1e-4);
  task.gait = GaitType::kHop;
  task.freedom = StepFreedom::kFree;
  EXPECT_EQ(MakeLimitTable("a", task, 0.1, {}).limits, MakeLimitTable("a", task, 0.0, {}).limits);
}

}  // namespace
}  // namespace sidestep::limit::limit_table_test
