// SPDX-License-Identifier: BSD-3-Clause
// The reduced models' shipped scenarios and their negative controls. The plant has no attitude:
// what would tip a robot over shows as angular momentum, so a run without step adjustment fails by
// that.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "sim/record/run_reader.h"
#include "tests/support/closed_loop.h"

namespace sidestep {
namespace {

using Overrides = std::vector<std::string>;

const Overrides kNoStepAdjustment{"control.mpc.box_lower_m=[0, 0, 0]",
                                  "control.mpc.box_upper_m=[0, 0, 0]"};
const std::string kRecovers =
    "expect={fall: false, recovery_time_s: {max: 3.0}, max_angular_momentum_kgm2ps: {max: 0.3}}";

std::string Describe(const std::string& name, const Overrides& overrides) {
  return ClosedLoopRun(name, overrides).Describe();
}

CsvTable TrajectoryOf(const ClosedLoopRun& run) {
  return CsvTable::Read(run.folder.path() / "trajectory.csv");
}

// Feet that the truth has on the ground, by row.
std::vector<int> StandingFeet(const CsvTable& trajectory) {
  std::vector<int> standing(trajectory.num_rows(), 0);
  for (const std::string& foot : FeetOf(trajectory)) {
    const std::vector<double> contact = trajectory.Numbers("truth_contact_" + foot);
    for (std::size_t row = 0; row < standing.size(); ++row) standing[row] += contact[row] > 0.5;
  }
  return standing;
}

struct Model {
  std::string scenario;
  std::string push;  ///< When it is pushed.
  std::string Push(const std::string& force_N) const {
    return "pushes=[{body: com, force_N: [0, " + force_N + ", 0], " + push + "}]";
  }
};

class CentroidalTest : public testing::TestWithParam<Model> {};

TEST_P(CentroidalTest, RecoversFromTheShippedPush) {
  EXPECT_EQ(Describe(GetParam().scenario, {}), "PASS");
}

TEST_P(CentroidalTest, RecoversFromTheOppositePush) {
  EXPECT_EQ(Describe(GetParam().scenario, {GetParam().Push("-5")}), "PASS");
}

TEST_P(CentroidalTest, RecoversFromAPushThatItIsNotToldOf) {
  EXPECT_EQ(Describe(GetParam().scenario, {"control.external_wrench=unknown"}), "PASS");
}

TEST_P(CentroidalTest, RecoversOnThePapersFriction) {
  EXPECT_EQ(Describe(GetParam().scenario,
                     {"control.mpc.friction=0.33", "world.friction=0.33", kRecovers}),
            "PASS");
}

TEST_P(CentroidalTest, FallsWhenItDoesNothing) {
  const ClosedLoopRun run(GetParam().scenario, {"control.mode=passive"});
  EXPECT_TRUE(run.FailedBy(reason::kFall)) << run.Describe();
}

TEST_P(CentroidalTest, FallsUnderTenTimesThePush) {
  const ClosedLoopRun run(GetParam().scenario, {GetParam().Push("50")});
  EXPECT_TRUE(run.FailedBy(reason::kFall)) << run.Describe();
}

TEST_P(CentroidalTest, FallsUnderTheShippedPushWhenItMayNotMoveItsSteps) {
  const ClosedLoopRun run(GetParam().scenario, kNoStepAdjustment);
  EXPECT_TRUE(run.FailedBy(reason::kFall)) << run.Describe();
}

TEST_P(CentroidalTest, NeedsNoStepAdjustmentWithoutAPush) {
  Overrides overrides = kNoStepAdjustment;
  overrides.emplace_back("pushes=[]");
  overrides.emplace_back("expect={fall: false, final_path_error_m: {max: 0.05}}");
  EXPECT_EQ(Describe(GetParam().scenario, overrides), "PASS");
}

TEST_P(CentroidalTest, RunsAlikeTwice) {
  const Overrides overrides{"duration_s=2.5", "expect={fall: false}"};
  const ClosedLoopRun first(GetParam().scenario, overrides);
  const ClosedLoopRun second(GetParam().scenario, overrides);
  const CsvTable once = TrajectoryOf(first);
  const CsvTable again = TrajectoryOf(second);
  ASSERT_EQ(once.header(), again.header());
  ASSERT_EQ(once.num_rows(), again.num_rows());
  ASSERT_GT(once.num_rows(), 2000U);
  for (const std::string& column : once.header()) {
    if (column.starts_with("wall_")) continue;
    for (std::size_t row = 0; row < once.num_rows(); ++row) {
      ASSERT_EQ(once.Text(row, column), again.Text(row, column)) << column << " in row " << row;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Paper, CentroidalTest,
                         testing::Values(Model{"one_leg", "start_s: 1.0, duration_s: 0.5"},
                                         Model{"two_legs", "start_s: 1.5, duration_s: 0.5"}),
                         [](const auto& one) { return one.param.scenario; });

// Two feet, one, two, ... while walking; one, none, one, ... from the change on.
TEST(TwoLegsTest, WalksWithoutFlightAndRunsWithoutDoubleSupport) {
  const ClosedLoopRun run("two_legs", {"pushes=[]", "expect={fall: false}"});
  const CsvTable trajectory = TrajectoryOf(run);
  const std::vector<double> time_s = trajectory.Numbers("time_s");
  const std::vector<int> standing = StandingFeet(trajectory);
  int walking_fewest = 2;
  int walking_most = 0;
  int running_most = 0;
  int flights = 0;
  for (std::size_t row = 1; row < time_s.size(); ++row) {
    if (time_s[row] < 1.06) {
      walking_fewest = std::min(walking_fewest, standing[row]);
      walking_most = std::max(walking_most, standing[row]);
    } else {  // the walk's last foot left at 1.05 s
      running_most = std::max(running_most, standing[row]);
      flights += standing[row] == 0 && standing[row - 1] > 0;
    }
  }
  EXPECT_EQ(walking_fewest, 1);
  EXPECT_EQ(walking_most, 2);
  EXPECT_EQ(running_most, 1);
  EXPECT_EQ(flights, 20);  // at 1.15 s and every 0.25 s to 5.9 s
}

// Gravity of plant and prediction are one number: nothing is left to correct.
TEST(TwoLegsTest, StandsAtItsHeightToTheSolversTolerance) {
  const ClosedLoopRun run("two_legs", {"gait={type: stand}", "pushes=[]", "expect={fall: false}"});
  const std::vector<double> height_m = TrajectoryOf(run).Numbers("truth_p_WC_z_m");
  EXPECT_NEAR(height_m.back(), 0.53, 1e-6);
}

// The nominal motion of the CoM never jumps, through the change of gait neither.
TEST(TwoLegsTest, NominalMotionIsSmoothThroughTheChangeOfGait) {
  const ClosedLoopRun run("two_legs", {"pushes=[]", "expect={fall: false}"});
  const CsvTable trajectory = TrajectoryOf(run);
  for (const std::string axis : {"x", "y", "z"}) {
    const std::vector<double> p_m = trajectory.Numbers("reference_p_WC_" + axis + "_m");
    const std::vector<double> v_mps = trajectory.Numbers("reference_v_WC_" + axis + "_mps");
    for (std::size_t row = 1; row < p_m.size(); ++row) {
      const double mean_mps = 0.5 * (v_mps[row] + v_mps[row - 1]);
      ASSERT_NEAR(p_m[row] - p_m[row - 1], 0.001 * mean_mps, 1e-6) << axis << " in row " << row;
      ASSERT_NEAR(v_mps[row], v_mps[row - 1], 0.03) << axis << " in row " << row;
    }
  }
}

}  // namespace
}  // namespace sidestep
