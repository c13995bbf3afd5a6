// SPDX-License-Identifier: BSD-3-Clause
#include "sim/compare/compare_runs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

namespace sidestep {
namespace {

TEST(CompareRunsTest, SettingsThatDifferAreToldByKey) {
  const auto all = CompareSettings("a: {b: 1, c: 2}\nlist: [1, 2]\n",
                                   "a: {b: 1, c: 3}\nlist: [1, 2, 4]\nd: x\n");
  ASSERT_EQ(all.size(), 3U);
  EXPECT_EQ(all[0].key, "a.c");
  EXPECT_EQ(all[0].first, "2");
  EXPECT_EQ(all[0].second, "3");
  EXPECT_EQ(all[1].key, "d");
  EXPECT_EQ(all[1].first, "");
  EXPECT_EQ(all[2].key, "list.2");
}

std::optional<Divergence> PartOf(const char* first, const char* second) {
  return CompareTrajectories(CsvTable::Parse(first, "a.csv"), CsvTable::Parse(second, "b.csv"));
}

TEST(CompareRunsTest, TrajectoriesPartAtTheFirstDigit) {
  const char* base = "time_s,x_m,wall_ms\n0,1,5\n0.001,2,6\n";
  EXPECT_FALSE(PartOf(base, "time_s,x_m,wall_ms\n0,1,7\n0.001,2,8\n"))
      << "a clock on the wall does not count";
  const auto digit = PartOf(base, "time_s,x_m,wall_ms\n0,1,5\n0.001,2.0001,6\n");
  ASSERT_TRUE(digit);
  EXPECT_EQ(digit->row, 1U);
  EXPECT_EQ(digit->time_s, "0.001");
  EXPECT_EQ(digit->column, "x_m");
  const auto end = PartOf(base, "time_s,x_m,wall_ms\n0,1,5\n");
  ASSERT_TRUE(end);
  EXPECT_EQ(end->row, 1U);
  EXPECT_EQ(end->column, "");
  EXPECT_FALSE(PartOf(base, "time_s,y_m,x_m\n0,9,1\n0.001,9,2\n"))
      << "columns are found by their names";
  EXPECT_FALSE(PartOf(base, "time_s,x_m\n0,1\n0.001,2\n0.0")) << "a row cut short is none";
}

StateLog TwoRows() {
  StateLog log;
  log.nq = 1;
  log.feet = {"left"};
  const Eigen::Vector3d ones = Eigen::Vector3d::Ones();
  for (const double time_s : {0.0, 0.002}) {
    log.rows.push_back({time_s, Eigen::VectorXd::Ones(1), ones, ones, {{ones, ones, ones, ones}}});
  }
  return log;
}

TEST(CompareRunsTest, StatesPartAtTheFirstBit) {
  EXPECT_FALSE(CompareStates(TwoRows(), TwoRows()));
  StateLog other = TwoRows();
  other.rows[1].qpos[0] = std::nextafter(1.0, 2.0);
  const auto bit = CompareStates(TwoRows(), other);
  ASSERT_TRUE(bit);
  EXPECT_EQ(bit->row, 1U);
  EXPECT_EQ(bit->time_s, "0.002");
  EXPECT_EQ(bit->column, "qpos");
  other = TwoRows();
  other.rows[0].feet[0].adjusted_p_WF.z() = 2.0;
  EXPECT_EQ(CompareStates(TwoRows(), other)->column, "left");
  other = TwoRows();
  other.rows[0].push_point_W.x() = 2.0;
  EXPECT_EQ(CompareStates(TwoRows(), other)->column, "push");
  other = TwoRows();
  other.rows.pop_back();
  EXPECT_EQ(CompareStates(TwoRows(), other)->column, "") << "one ends";
  EXPECT_EQ(CompareStates(other, TwoRows())->time_s, "0.002");
  other = TwoRows();
  other.feet = {"right"};
  EXPECT_EQ(CompareStates(TwoRows(), other)->column, "their robots");
}

TEST(CompareRunsTest, RowsOfLogsOfAnotherDetailAreNotCompared) {
  RunComparison comparison;
  comparison.has_trajectories = comparison.has_states = true;
  comparison.second_log = LogDetail::kNormal;
  EXPECT_EQ(DivergenceText(comparison),
            "trajectories: not compared, for one log is full and the other normal");
  EXPECT_EQ(StatesText(comparison), "states: the same bit for bit");
  comparison.first_log = LogDetail::kNormal;
  EXPECT_EQ(DivergenceText(comparison),
            "trajectories: the same in the rows and digits of their logs");
  comparison.states_divergence = Divergence{3, "0.006", "qpos"};
  EXPECT_EQ(StatesText(comparison), "states: part at row 3, 0.006 s, in qpos");
}

TEST(CompareRunsTest, TextHasChangesOfWhatDiffers) {
  RunComparison comparison;
  comparison.first_verdict = "PASS";
  comparison.second_verdict = "FAIL";
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  comparison.metrics = {{"drift_m", 0.5, 0.25}, {"fall", 0.0, 1.0}, {"same", kNan, kNan}};
  comparison.has_trajectories = true;
  comparison.divergence = Divergence{3, "0.003", "x_m"};
  EXPECT_EQ(RunComparisonText(comparison),
            "verdict: PASS -> FAIL\nsettings that differ: 0\n"
            "metrics: 2 differ, 1 are the same\n  drift_m: 0.5 -> 0.25  (-0.25, -50.0 %)\n"
            "  fall: 0 -> 1  (+1)\ntrajectories: part at row 3, 0.003 s, in x_m\n");
}

}  // namespace
}  // namespace sidestep
