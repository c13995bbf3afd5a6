// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// record_test_support: a two-footed world without physics, and a folder to record it into.

#include <gtest/gtest.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "sim/record/recorder.h"
#include "sim/scenario/scenario.h"
#include "sim/world/world.h"

namespace sidestep {

inline Scenario TwoFeetScenario() {
  Scenario scenario;
  scenario.name = "two feet";
  scenario.file = "test.yaml";
  scenario.robot_name = "two_legs";
  scenario.plant = Plant::kCentroidal;
  scenario.duration_s = 0.1;
  scenario.control.rate_hz = 500.0;
  scenario.gait.resize(1);
  scenario.gait[0].start_s = 0.0;
  RobotDescription& robot = scenario.robot;
  robot.name = "two_legs";
  robot.file = std::filesystem::path(SIDESTEP_SOURCE_DIR) / "models/two_legs/robot.yaml";
  robot.mass_kg = 2.0;
  robot.com_height_m = 0.5;
  robot.feet = {{"left", "left", {}, Eigen::Vector3d::Zero(), 0.0},
                {"right", "right", {}, Eigen::Vector3d::Zero(), 0.0}};
  Push push;
  push.body = "com";
  push.force_N = {0.0, 5.0, 0.0};
  push.duration_s = 0.05;
  scenario.pushes = {push, push};
  return scenario;
}

/// Times on the wall; half as much of the processor.
inline TickTimes TimesOf(double control_ms, double mpc_ms, double whole_body_ms) {
  return {
      {control_ms, 0.5 * control_ms}, {mpc_ms, 0.5 * mpc_ms}, {whole_body_ms, 0.5 * whole_body_ms}};
}

/// A world whose truth a test writes by hand.
class ScriptedWorld final : public World {
 public:
  explicit ScriptedWorld(const Scenario& scenario, std::vector<JointInfo> joints = {})
      : joints_(std::move(joints)) {
    written.qpos.setZero(21);
    written.joint_position.setZero(static_cast<Eigen::Index>(joints_.size()));
    written.joint_torque_Nm = written.joint_position;
    written.feet.resize(scenario.robot.feet.size());
    written.pushes.resize(scenario.pushes.size());
  }
  std::unique_ptr<World> Clone() const override { return std::make_unique<ScriptedWorld>(*this); }
  const WorldTruth& truth() const override { return written; }
  bool is_valid() const override { return true; }
  const std::string& invalid_reason() const override { return reason_; }
  double mass_kg() const override { return 2.0; }
  const std::vector<JointInfo>& joints() const override { return joints_; }
  void ReplacePushes(const std::vector<Push>&, Tick) override {}
  void Apply(const ActuatorCommand&) override {}
  void Step(Tick) override {}

  WorldTruth written;

 private:
  std::vector<JointInfo> joints_;
  std::string reason_;
};

/// A folder of its own for each test, gone afterwards.
class RecordTest : public ::testing::Test {
 protected:
  RecordTest()
      : folder_(std::filesystem::path(::testing::TempDir()) /
                (std::string("sidestep_record_") +
                 ::testing::UnitTest::GetInstance()->current_test_info()->name())) {
    std::filesystem::remove_all(folder_);
  }
  ~RecordTest() override { std::filesystem::remove_all(folder_); }

  const std::filesystem::path folder_;
};

/// What a controller thinks at `tick`: every number distinct.
inline ControlTick BusyControl(Tick tick) {
  ControlTick control;
  control.tick = tick;
  control.state.p_WC = {0.1, 0.2, 0.3};
  control.state.feet.resize(2);
  control.state.feet[0].wrench = {{10.1, 10.2, 10.3}, {10.4, 10.5, 10.6}};
  control.state.external_wrench = {{9.1, 9.2, 9.3}, {9.4, 9.5, 9.6}};
  control.reference.v_WC = {1.1, 1.2, 1.3};
  control.com.p_WC = {2.1, 2.2, 2.3};
  control.feet.resize(2);
  control.feet[1].planned_contact = true;
  control.feet[1].force_N = {3.1, 3.2, 3.3};
  control.feet[1].p_WF = {4.1, 4.2, 4.3};
  control.feet[1].contact.nominal_p_WF = {5.1, 5.2, 5.3};
  control.feet[1].contact.adjusted_p_WF = {6.1, 6.2, 6.3};
  control.mpc = {true, SolveStatus::kSolved, 17, 1.5, 1e-9, 2e-7, false};
  control.mpc_age_s = 0.004;
  return control;
}

}  // namespace sidestep
