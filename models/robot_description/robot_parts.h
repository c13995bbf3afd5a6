// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// robot_parts: what every robot.yaml holds, whatever its model is written in.

#include <map>
#include <string>
#include <vector>

#include "models/robot_description/mjcf_names.h"
#include "models/robot_description/robot_description.h"
#include "models/support/config_node.h"

namespace sidestep {

inline constexpr double kMaxLength_m = 10.0;  ///< No legged robot is larger; catches millimetres.
inline constexpr double kMaxMass_kg = 1e4;

/// What the names of a robot.yaml refer to.
struct KnownParts {
  ModelLanguage language{ModelLanguage::kMjcf};  ///< Named in error texts.
  MjcfNames names;                               ///< Of the model, or what a URDF's will be.
  /// What the model's own language calls it.
  std::string base_kind{"floating body (a free joint, or slides x, z and hinge y)"};
  std::string frame_kind{"site"};
};

/// Text that must not be empty.
std::string ReadName(const ConfigNode& node);

/// Elements that are texts, none empty, no two the same.
std::vector<std::string> ReadNames(const ConfigNode& node);

/// A name that must be among `known`, the model's parts of that kind.
std::string ReadPart(const ConfigNode& node, const std::vector<std::string>& known,
                     const std::string& kind, ModelLanguage language);

/// Names that must be among `known`, no two the same.
std::vector<std::string> ReadParts(const ConfigNode& node, const std::vector<std::string>& known,
                                   const std::string& kind, ModelLanguage language);

/// A list of exactly `count` finite numbers.
std::vector<double> ReadNumbers(const ConfigNode& node, std::size_t count);

/// Throws ConfigError at `at` unless the model has the sensor.
void RequireSensor(const ConfigNode& at, const KnownParts& parts, const std::string& sensor);

/// The list of feet. `parts` is null for a robot without a model, whose feet are points of the
/// centroidal plant.
std::vector<FootDescription> ReadFeet(const ConfigNode& node, const KnownParts* parts);

/// The keys common to robots with a model but `mjcf` or `urdf` itself: base, imu, torso, home pose,
/// force/torque sensors of the arms, feet. Reads robot->force_torque.
void ReadModelParts(ConfigMap& map, const KnownParts& parts, RobotDescription* robot);

}  // namespace sidestep
