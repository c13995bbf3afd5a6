// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// body_plan: which joints and links are legs, arms and torso, found by structure.
//
// Legs are two branches with as many joints each whose ends are the lowest links of the robot;
// arms are two other branches that mirror each other. Places count; names only tell left and right.

#include <array>
#include <string>
#include <vector>

#include "models/import/problems.h"
#include "models/import/source_robot.h"

namespace sidestep::importer {

inline constexpr std::size_t kLegJoints = 6;       ///< What a sole on the ground needs.
inline constexpr std::size_t kAnkleJoints = 2;     ///< The last of them.
inline constexpr std::size_t kPointLegJoints = 3;  ///< What a point on the ground needs.
inline constexpr std::size_t kMaxArmJoints = 4;    ///< Shoulder and elbow; the wrist is locked.

/// A chain of joints that move, from the trunk outwards.
struct Limb {
  std::vector<int> joints;
  int end{-1};  ///< The link that the last joint moves: foot or forearm.
};

/// Left first in every pair.
struct BodyPlan {
  std::array<Limb, 2> legs;
  std::array<Limb, 2> arms;       ///< Without joints if there are none.
  std::vector<int> torso_joints;  ///< Between legs and torso, the lowest first.
  int pelvis{0};                  ///< Link at which the legs part.
  int torso{0};                   ///< Link that carries the arms, else the heaviest but legs.
  std::vector<int> locked;        ///< All other joints that move.
  /// Angle about z from the URDF's x to where the robot faces, at zero.
  double facing_rad{0.0};

  bool has_arms() const { return !arms[0].joints.empty(); }
  /// Whether each leg can put a point where it likes, and no sole.
  bool stands_on_points() const { return legs[0].joints.size() == kPointLegJoints; }
  /// In the order of the actuators: left leg, right leg, torso, left arm, right arm.
  std::vector<int> Actuated() const;
};

/// Finds the plan. Throws ConfigError, naming `file`, with the reason where there is none: no two
/// legs, or neither six joints in a leg nor three.
BodyPlan FindBodyPlan(const SourceRobot& robot, const std::string& file, Notes* notes);

}  // namespace sidestep::importer
