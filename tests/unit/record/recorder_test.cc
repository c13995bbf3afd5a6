// SPDX-License-Identifier: BSD-3-Clause
#include "sim/record/recorder.h"

#include <gtest/gtest.h>

#include <cmath>

#include "sim/record/run_reader.h"
#include "sim/record/run_summary.h"
#include "tests/unit/record/record_test_support.h"

namespace sidestep::recorder_test {
namespace {

using RecorderTest = RecordTest;

TEST_F(RecorderTest, RowsReadBackBitForBit) {
  const Scenario scenario = TwoFeetScenario();
  ScriptedWorld world(scenario);
  world.written.p_WC = {1.0 / 3.0, -2.0e-17, 1e300};
  world.written.q_WB = Eigen::Quaterniond(0.5, 0.1, 0.2, 0.3);
  world.written.feet[1].f_F_W = {7.1, 7.2, 7.3};
  world.written.feet[1].m_F_W = {8.1, 8.2, 8.3};
  world.written.feet[1].R_WF = Eigen::Quaterniond(0.6, 0.0, 0.0, 0.8).toRotationMatrix();
  world.written.feet[1].in_contact = true;
  world.written.pushes[0].force_W_N = {1.0, 2.0, 3.0};
  world.written.pushes[1].force_W_N = {10.0, 20.0, 30.0};
  Recorder recorder(scenario, world, folder_, {"sidestep", "run"});
  recorder.Add(0, world.truth(), BusyControl(0), TimesOf(1.25, 1.0, 0.125));
  recorder.Add(2, world.truth(), BusyControl(2), TimesOf(0.25, 0.75, 0.125));
  recorder.Finish({}, 0.004, {0.1, 0.1});

  const CsvTable table = CsvTable::Read(folder_ / "trajectory.csv");
  ASSERT_EQ(table.num_rows(), 2u);
  const auto last = [&](const std::string& column) { return table.Numbers(column).back(); };
  EXPECT_EQ(last("time_s"), 0.002);
  EXPECT_EQ(last("truth_p_WC_x_m"), 1.0 / 3.0);
  EXPECT_EQ(last("truth_p_WC_y_m"), -2.0e-17);
  EXPECT_EQ(last("truth_p_WC_z_m"), 1e300);
  EXPECT_EQ(last("truth_q_WB_w"), 0.5);
  EXPECT_EQ(last("truth_q_WB_z"), 0.3);
  EXPECT_EQ(last("truth_f_F_W_right_z_N"), 7.3);
  EXPECT_EQ(last("truth_m_F_W_right_y_Nm"), 8.2);
  EXPECT_NEAR(last("truth_q_WF_right_z"), 0.8, 1e-15);
  EXPECT_EQ(last("truth_q_WF_left_w"), 1.0);
  EXPECT_EQ(last("truth_contact_right"), 1.0);
  EXPECT_EQ(last("truth_contact_left"), 0.0);
  EXPECT_EQ(last("push_force_W_y_N"), 22.0) << "the sum of both pushes";
  EXPECT_EQ(last("belief_p_WC_y_m"), 0.2);
  EXPECT_EQ(last("belief_push_force_W_x_N"), 9.1);
  EXPECT_EQ(last("belief_push_torque_C_W_z_Nm"), 9.6);
  EXPECT_EQ(last("belief_f_F_W_left_z_N"), 10.3);
  EXPECT_EQ(last("belief_m_F_W_left_x_Nm"), 10.4);
  EXPECT_EQ(last("reference_v_WC_z_mps"), 1.3);
  EXPECT_EQ(last("mpc_p_WC_x_m"), 2.1);
  EXPECT_EQ(last("planned_contact_right"), 1.0);
  EXPECT_EQ(last("mpc_f_F_W_right_x_N"), 3.1);
  EXPECT_EQ(last("swing_p_WF_right_y_m"), 4.2);
  EXPECT_EQ(last("nominal_p_WF_right_x_m"), 5.1);
  EXPECT_EQ(last("adjusted_p_WF_right_z_m"), 6.3);
  EXPECT_EQ(last("mpc_age_s"), 0.004);
  EXPECT_EQ(last("wall_control_ms"), 0.25);
  EXPECT_EQ(last("wall_whole_body_ms"), 0.125);
  EXPECT_EQ(table.header().back(), "wall_mpc_ms") << "wall-clock columns come last";
}

TEST_F(RecorderTest, AControllerThatOnlyCommandsLeavesBeliefAndPlanEmpty) {
  const Scenario scenario = TwoFeetScenario();
  ScriptedWorld world(scenario);
  Recorder recorder(scenario, world, folder_, {});
  ControlTick silent;
  silent.command.torque_Nm.setZero(world.truth().joint_position.size());
  recorder.Add(0, world.truth(), silent, TimesOf(1.0, 0.0, 0.0));
  recorder.Add(2, world.truth(), BusyControl(2), TimesOf(1.0, 1.0, 0.125));
  recorder.Finish({}, 0.004, {0.1, 0.1});

  const CsvTable table = CsvTable::Read(folder_ / "trajectory.csv");
  for (const std::string& column : table.header()) {
    const bool is_thought = column.starts_with("belief_") || column.starts_with("reference_") ||
                            column.starts_with("mpc_") || column.starts_with("nominal_") ||
                            column.starts_with("planned_") || column.starts_with("swing_") ||
                            column == "wbc_status";
    if (!is_thought) continue;
    EXPECT_EQ(table.Text(0, column), "") << column;
    EXPECT_NE(table.Text(1, column), "") << column;
  }
}

TEST_F(RecorderTest, StatesHoldTheStrongestPushAndThePlan) {
  const Scenario scenario = TwoFeetScenario();
  ScriptedWorld world(scenario);
  for (Eigen::Index i = 0; i < 21; ++i) world.written.qpos[i] = 0.1 * static_cast<double>(i);
  world.written.pushes[0] = {{0.0, -9.0, 0.0}, {1.0, 1.0, 1.0}};
  world.written.pushes[1] = {{8.0, 0.0, 0.0}, {2.0, 2.0, 2.0}};
  world.written.feet[0].p_WF = {0.5, 0.6, 0.7};
  Recorder recorder(scenario, world, folder_, {});
  recorder.Add(0, world.truth(), BusyControl(0), TimesOf(1.0, 1.0, 0.125));
  recorder.Add(2, world.truth(), ControlTick{}, TimesOf(1.0, 0.0, 0.125));
  recorder.Finish({}, 0.004, {0.1, 0.1});

  const StateLog log = ReadStates(folder_);
  EXPECT_EQ(log.nq, 21);
  EXPECT_EQ(log.dt_s, 0.002);
  EXPECT_EQ(log.feet, (std::vector<std::string>{"left", "right"}));
  ASSERT_EQ(log.rows.size(), 2u);
  EXPECT_EQ(log.rows[0].qpos, world.written.qpos);
  EXPECT_EQ(log.rows[0].push_force_W, Eigen::Vector3d(0.0, -9.0, 0.0));
  EXPECT_EQ(log.rows[0].push_point_W, Eigen::Vector3d(1.0, 1.0, 1.0));
  EXPECT_EQ(log.rows[0].feet[1].nominal_p_WF, Eigen::Vector3d(5.1, 5.2, 5.3));
  EXPECT_EQ(log.rows[0].feet[1].adjusted_p_WF, Eigen::Vector3d(6.1, 6.2, 6.3));
  EXPECT_EQ(log.rows[1].feet[0].adjusted_p_WF, world.written.feet[0].p_WF)
      << "a controller without a plan leaves the foot where it is";
}

TEST_F(RecorderTest, SolvesHaveARowEachAndOtherTicksHaveNone) {
  const Scenario scenario = TwoFeetScenario();
  const ScriptedWorld world(scenario);
  Recorder recorder(scenario, world, folder_, {});
  recorder.Add(0, world.truth(), BusyControl(0), TimesOf(3.0, 2.5, 0.125));
  ControlTick quiet = BusyControl(2);
  quiet.mpc.ran = false;
  recorder.Add(2, world.truth(), quiet, TimesOf(0.5, 0.0, 0.125));
  recorder.Finish({}, 0.004, {0.1, 0.1});

  const CsvTable table = CsvTable::Read(folder_ / "mpc.csv");
  ASSERT_EQ(table.num_rows(), 1u);
  EXPECT_EQ(table.Text(0, "status"), "solved");
  EXPECT_EQ(table.Numbers("iterations")[0], 17.0);
  EXPECT_EQ(table.Numbers("kkt_error")[0], 2e-7);
  EXPECT_EQ(table.Numbers("wall_ms")[0], 2.5);
  EXPECT_EQ(table.Numbers("cpu_ms")[0], 1.25);
  const RunSummary summary = ReadSummary(folder_);
  EXPECT_EQ(summary.solve_time.count, 1);
  EXPECT_EQ(summary.whole_body_time.count, 2);
  EXPECT_EQ(summary.whole_body_time.mean_ms, 0.125);
  EXPECT_EQ(summary.solve_cpu.mean_ms, 1.25);
  EXPECT_EQ(summary.whole_body_cpu.mean_ms, 0.0625);
}

TEST_F(RecorderTest, FootstepsReadBackWithEmptyPlacesForThoseThatNeverLanded) {
  const Scenario scenario = TwoFeetScenario();
  const ScriptedWorld world(scenario);
  Recorder recorder(scenario, world, folder_, {});
  RunOutcome outcome;
  PlannedContact contact;
  contact.index = 4;
  contact.start_tick = 120;
  contact.end_tick = 350;
  contact.nominal_p_WF = {1.0, 2.0, 3.0};
  contact.adjusted_p_WF = {1.5, 2.5, 3.5};
  contact.box_lower_m = {-0.1, -0.2, 0.0};
  contact.box_upper_m = {0.3, 0.4, 0.0};
  contact.R_WF = Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitZ());
  outcome.footsteps = {{1, contact, true, Eigen::Vector3d(7.0, 8.0, 9.0), 0.01},
                       {0, contact, false, {}, 0.0}};
  recorder.Finish(outcome, 0.004, {0.1, 0.1});

  const std::vector<Footstep> steps = ReadFootsteps(folder_);
  ASSERT_EQ(steps.size(), 2u);
  EXPECT_EQ(steps[0].foot, "right");
  EXPECT_EQ(steps[0].index, 4);
  EXPECT_DOUBLE_EQ(steps[0].start_s, 0.12);
  EXPECT_DOUBLE_EQ(steps[0].end_s, 0.35);
  EXPECT_EQ(steps[0].adjusted_p_WF, contact.adjusted_p_WF);
  EXPECT_EQ(steps[0].realised_p_WF, Eigen::Vector3d(7.0, 8.0, 9.0));
  EXPECT_EQ(steps[0].slip_m, 0.01);
  EXPECT_EQ(steps[0].box_upper_m, Eigen::Vector2d(0.3, 0.4));
  EXPECT_NEAR(steps[0].yaw_rad, 0.3, 1e-15);
  EXPECT_FALSE(steps[1].realised_p_WF.has_value());
  EXPECT_FALSE(steps[1].box_lower_m.array().isFinite().any()) << "nobody planned one";
}

TEST_F(RecorderTest, SlidingJointsAreInNewtonsAndMetres) {
  const Scenario scenario = TwoFeetScenario();
  const ScriptedWorld world(scenario, {{"hip_roll"}, {"hip_pitch"}, {"leg", true}});
  Recorder recorder(scenario, world, folder_, {});
  ControlTick control = BusyControl(0);
  control.command.torque_Nm = Eigen::Vector3d(1.0, 2.0, 3.0);
  recorder.Add(0, world.truth(), control, TimesOf(1.0, 0.0, 0.125));
  recorder.Finish({}, 0.002, {0.1, 0.1});
  const CsvTable table = CsvTable::Read(folder_ / "trajectory.csv");
  EXPECT_EQ(table.Numbers("command_hip_pitch_Nm")[0], 2.0);
  EXPECT_EQ(table.Numbers("command_leg_N")[0], 3.0);
  EXPECT_TRUE(table.has("joint_leg_m"));
  EXPECT_TRUE(table.has("joint_hip_roll_rad"));
}

TEST_F(RecorderTest, PushHasItsMomentAboutTheCom) {
  const Scenario scenario = TwoFeetScenario();
  ScriptedWorld world(scenario);
  world.written.p_WC = {0.0, 0.0, 0.5};
  world.written.pushes[0] = {{0.0, 10.0, 0.0}, {0.0, 0.0, 0.9}};
  world.written.pushes[1] = {{0.0, 0.0, 5.0}, {0.0, 0.2, 0.5}};
  Recorder recorder(scenario, world, folder_, {});
  recorder.Add(0, world.truth(), ControlTick{}, {});
  recorder.Finish({}, 0.002, {0.1, 0.1});
  // By hand: (0, 0, 0.4) x (0, 10, 0) + (0, 0.2, 0) x (0, 0, 5).
  const CsvTable table = CsvTable::Read(folder_ / "trajectory.csv");
  EXPECT_NEAR(table.Numbers("push_torque_C_W_x_Nm")[0], -4.0 + 1.0, 1e-12);
}

TEST_F(RecorderTest, PositionControlTellsReferencesAndTheMotorsTorques) {
  Scenario scenario = TwoFeetScenario();
  scenario.control.mode = ControlMode::kPosition;
  ScriptedWorld world(scenario, {{"hip"}, {"leg", true}});
  world.written.joint_torque_Nm = Eigen::Vector2d(5.5, 6.5);
  Recorder recorder(scenario, world, folder_, {});
  ControlTick control = BusyControl(0);
  control.command.joint_position = Eigen::Vector2d(0.1, 0.2);
  control.command.joint_velocity = Eigen::Vector2d(0.3, 0.4);
  recorder.Add(0, world.truth(), control, {});
  recorder.Add(2, world.truth(), ControlTick{}, {});
  recorder.Finish({}, 0.002, {0.1, 0.1});
  const CsvTable table = CsvTable::Read(folder_ / "trajectory.csv");
  EXPECT_EQ(table.Numbers("command_hip_rad")[0], 0.1);
  EXPECT_EQ(table.Numbers("command_hip_radps")[0], 0.3);
  EXPECT_EQ(table.Numbers("command_leg_m")[0], 0.2);
  EXPECT_EQ(table.Numbers("command_leg_mps")[0], 0.4);
  EXPECT_EQ(table.Text(1, "command_hip_rad"), "") << "it commanded nothing";
  EXPECT_FALSE(table.has("command_hip_Nm"));
  EXPECT_EQ(table.Numbers("joint_hip_Nm")[0], 5.5);
  EXPECT_EQ(table.Numbers("joint_leg_N")[0], 6.5);
}

TEST_F(RecorderTest, WhatTheControllerDoesNotSayIsAnEmptyCell) {
  const Scenario scenario = TwoFeetScenario();
  const ScriptedWorld world(scenario);
  Recorder recorder(scenario, world, folder_, {});
  recorder.Add(0, world.truth(), ControlTick{}, TimesOf(1.0, 0.0, 0.125));
  recorder.Finish({}, 0.002, {0.1, 0.1});
  const CsvTable table = CsvTable::Read(folder_ / "trajectory.csv");
  ASSERT_EQ(table.num_rows(), 1u);
  EXPECT_EQ(table.Text(0, "planned_contact_left"), "");
  EXPECT_EQ(table.Text(0, "adjusted_p_WF_right_x_m"), "");
  EXPECT_EQ(table.Text(0, "truth_contact_left"), "0");
}

}  // namespace
}  // namespace sidestep::recorder_test
