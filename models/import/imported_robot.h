// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// imported_robot: all that an import has found out, for those who write it down.

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "models/import/body_plan.h"
#include "models/import/choose_gait.h"
#include "models/import/choose_motors.h"
#include "models/import/feet.h"
#include "models/import/source_robot.h"
#include "models/import/start_pose.h"

namespace sidestep::importer {

/// Every link of the first list against every one of the second.
struct CollisionPairs {
  std::vector<std::string> first;
  std::vector<std::string> second;
};

struct ImportedRobot {
  std::string name;    ///< A plain word.
  std::string mode;    ///< position or torque.
  std::string source;  ///< The URDF's or MJCF's file name.
  SourceRobot robot;
  BodyPlan plan;
  std::array<Foot, 2> feet;
  std::string imu;    ///< A link without mass.
  std::string torso;  ///< Likewise.
  StartPose start;
  double mass_kg{0.0};
  std::vector<MotorGroup> motors;
  Gait gait;
  ControlFigures control;
  std::vector<CollisionPairs> self_collision;

  const std::string& Link(int link) const {
    return robot.links[static_cast<std::size_t>(link)].name;
  }
  /// Whether the source tells no armature of some joint with a motor.
  bool LacksArmature() const {
    const std::vector<int> joints = plan.Actuated();
    return std::any_of(joints.begin(), joints.end(), [&](int joint) {
      return robot.joints[static_cast<std::size_t>(joint)].armature_kgm2 <= 0.0;
    });
  }

  const std::string& Joint(int joint) const {
    return robot.joints[static_cast<std::size_t>(joint)].name;
  }
};

}  // namespace sidestep::importer
