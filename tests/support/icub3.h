// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// icub3: the iCub that ships, and states of it.

#include <cmath>
#include <filesystem>

#include "controller/model/rigid_body.h"
#include "models/robot_description/robot_description.h"

namespace sidestep {

inline RobotDescription Icub3() {
  return ReadRobotDescription(std::filesystem::path(SIDESTEP_SOURCE_DIR) /
                              "models/icub3/robot.yaml");
}

/// Tilted and all in motion, the joints in the middle 60 % of their ranges; another state for each
/// `variant`.
inline RobotState MovingIcub(const RigidBody& body, int variant) {
  RobotState state;
  state.p_WB = {0.3, -0.2, 0.7 + 0.1 * variant};
  state.q_WB = Eigen::Quaterniond(0.7, 0.3 - 0.2 * variant, -0.4, 0.5).normalized();
  state.v_WB = {0.4, -0.7, 0.2};
  state.w_WB_B = {1.1, -0.6, 0.9 - 0.5 * variant};
  const int joints = body.num_actuators();
  state.joint_position.setZero(joints);
  state.joint_velocity.setZero(joints);
  for (int i = 0; i < joints; ++i) {
    const double share = 0.2 + 0.6 * std::fmod(0.618034 * (i + 1) * (variant + 1), 1.0);
    state.joint_position[i] =
        body.joint_lower()[i] + share * (body.joint_upper()[i] - body.joint_lower()[i]);
    state.joint_velocity[i] = 1.5 * std::sin(1.7 * i + variant);
  }
  state.feet.resize(body.num_feet());
  return state;
}

/// At home, at rest, both feet in contact; `body` is left there.
inline RobotState IcubAtHome(RigidBody* body) {
  RobotState state;
  state.feet.resize(body->num_feet());
  body->WriteHome(&state);
  body->Update(state);
  body->FillDerived(&state);
  for (FootState& foot : state.feet) foot.in_contact = true;
  return state;
}

}  // namespace sidestep
