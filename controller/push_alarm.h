// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// push_alarm: whether a robot has been pushed lately, told from what its plan did not foresee.
//
// From one solve to the next the MPC's plan tells where the capture point will be. What it is off
// by then, nobody planned: summed up over some 0.2 s, a walk's own errors stay below 3 cm, and a
// shove of 0.5 N s/kg is 12 cm. A push that is felt is in the plan; it counts by how far it moves
// the place from which a linear pendulum would be in balance, F / (m w^2).

#include <Eigen/Core>
#include <optional>

#include "controller/types/control_tick.h"
#include "controller/types/robot_state.h"
#include "controller/types/tick.h"

namespace sidestep {

class PushAlarm {
 public:
  /// @param error_m   Beyond this a push is noticed (> 0). @param alert_s  So long it counts.
  /// @param height_m  Of the nominal CoM above the ground. @param tick_s   One tick.
  PushAlarm(double error_m, double alert_s, double height_m, double mass_kg, double tick_s);

  /// Whether a push has been noticed within alert_s before `tick`. `planned`: the CoM at `tick` by
  /// the plan in use. Call before each solve.
  bool Update(const RobotState& state, const ComTarget& planned, Tick tick);

 private:
  double error_m_;
  double height_m_;
  double mass_kg_;
  double tick_s_;
  Tick alert_;
  Tick last_{0};
  Eigen::Vector3d unforeseen_m_{Eigen::Vector3d::Zero()};
  std::optional<Tick> noticed_;
};

}  // namespace sidestep
