// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// verdict_test_support: a scripted robot on one foot, for judges to watch.

#include <functional>
#include <numbers>

#include "controller/types/control_tick.h"
#include "sim/scenario/scenario.h"
#include "sim/verdict/judge.h"
#include "sim/world/world.h"

namespace sidestep {

inline constexpr double kTestMass_kg = 10.0;
inline constexpr Tick kControlPeriod = 2;  ///< Ticks; 500 Hz.

/// A hopper of 10 kg with its base at 0.6 m, that stands.
inline Scenario OneFootScenario() {
  Scenario scenario;
  scenario.name = "test";
  scenario.duration_s = 1.0;
  RobotDescription& robot = scenario.robot;
  robot.name = "one_foot";
  robot.com_height_m = 0.5;
  robot.base_height_m = 0.6;
  robot.feet = {{"foot", "sole", {}, Eigen::Vector3d::Zero(), 0.02}};
  scenario.gait.resize(1);
  return scenario;
}

/// The robot of OneFootScenario at rest, loaded, with no push acting.
inline WorldTruth StandingTruth(const Scenario& scenario) {
  WorldTruth truth;
  truth.qpos.setZero(7);
  truth.qpos[3] = 1.0;
  truth.p_WB.z() = 0.6;
  truth.p_WC.z() = 0.5;
  truth.feet.resize(scenario.robot.feet.size());
  for (FootTruth& foot : truth.feet) {
    foot.p_WF.z() = 0.02;
    foot.f_F_W.z() = 98.1;
    foot.in_contact = true;
  }
  truth.pushes.resize(scenario.pushes.size());
  return truth;
}

/// What a controller thinks that wants just that; its MPC solves every time.
inline ControlTick StandingControl(const Scenario& scenario) {
  ControlTick control;
  control.reference.p_WC.z() = 0.5;
  control.feet.resize(scenario.robot.feet.size());
  for (FootTarget& foot : control.feet) {
    foot.planned_contact = true;
    foot.contact.end_tick = 1 << 20;
  }
  control.mpc.ran = true;
  control.mpc.status = SolveStatus::kSolved;
  return control;
}

/// A robot on two feet 0.16 m apart that walks 0.1 m a step, left foot first: from 0.2 s on, 0.6 s
/// in the air and 0.2 s on both feet, so that touch-downs are 0.8 s apart and a gait cycle is 1.6
/// s.
inline Scenario TwoFeetScenario() {
  Scenario scenario = OneFootScenario();
  scenario.robot.feet = {{"left", "left_sole", {}, Eigen::Vector3d::Zero(), 0.02},
                         {"right", "right_sole", {}, Eigen::Vector3d::Zero(), 0.02}};
  scenario.gait[0].type = GaitType::kWalk;
  scenario.gait[0].step_length_m = 0.1;
  scenario.duration_s = 10.0;
  return scenario;
}

/// What is asked of its robot.
inline NominalMotion NominalOf(const Scenario& scenario) {
  return {scenario.robot, AskedGaitOf(scenario)};
}

inline Judge JudgeOf(const Scenario& scenario, const std::vector<JointInfo>& joints = {}) {
  return {MeterSetupOf(scenario, kTestMass_kg, joints), scenario.expect};
}

/// Changes what is true and thought at a tick.
using Script = std::function<void(Tick, WorldTruth&, ControlTick&)>;

/// Shows `judge` ticks 0 to `end` of a standing robot changed by `script`, or until it is finished;
/// returns the last tick shown.
inline Tick Watch(Judge& judge, const Scenario& scenario, Tick end, const Script& script) {
  Tick tick = 0;
  for (; tick <= end; ++tick) {
    WorldTruth truth = StandingTruth(scenario);
    ControlTick control = StandingControl(scenario);
    control.tick = tick;
    script(tick, truth, control);
    judge.Add(tick, truth, tick % kControlPeriod == 0 ? &control : nullptr);
    if (judge.finished()) return tick;
  }
  return end;
}

/// The whole of it.
inline RunOutcome OutcomeOf(const Scenario& scenario, Tick end, const Script& script) {
  Judge judge = JudgeOf(scenario);
  Watch(judge, scenario, end, script);
  return judge.Conclude();
}

inline double NumberOf(const RunOutcome& outcome, const std::string& metric) {
  return std::get<double>(outcome.metrics.at(metric));
}

inline bool FlagOf(const RunOutcome& outcome, const std::string& metric) {
  return std::get<bool>(outcome.metrics.at(metric));
}

}  // namespace sidestep
