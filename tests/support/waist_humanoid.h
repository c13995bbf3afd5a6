// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// waist_humanoid: the generic humanoid with a pitching joint in its waist, as one machine that two
// models describe: rooted in its pelvis, below the waist, or in its trunk, above it.

#include <filesystem>
#include <string>

#include "models/support/config_text.h"
#include "tests/support/temp_folder.h"

namespace sidestep {

enum class WaistRoot { kPelvis, kTrunk };

namespace internal {

inline std::string WaistJoint(const std::string& name, const std::string& parent,
                              const std::string& child, double z_m, const std::string& axis) {
  return "  <joint name=\"" + name + "\" type=\"revolute\"><parent link=\"" + parent +
         "\"/><child link=\"" + child + "\"/><origin xyz=\"0 0 " + std::to_string(z_m) +
         "\"/><axis xyz=\"" + axis +
         "\"/><limit lower=\"-1\" upper=\"1\" effort=\"150\" velocity=\"6\"/></joint>\n";
}

/// `text` without what is from `from` to the next `to`, `to` included.
inline std::string Without(std::string text, const std::string& from, const std::string& to) {
  const std::size_t begin = text.find(from);
  const std::size_t end = text.find(to, begin);
  EXPECT_NE(end, std::string::npos) << from;
  return text.erase(begin, end + to.size() - begin);
}

}  // namespace internal

/// Writes the robot into `folder` and returns its robot.yaml. The IMU is on the trunk: each root
/// has the same senses.
inline std::filesystem::path WaistHumanoid(const TempFolder& folder, WaistRoot root) {
  constexpr double kHalfWaist_m = 0.06;
  const std::filesystem::path shipped =
      std::filesystem::path(SIDESTEP_SOURCE_DIR) / "models/generic_humanoid";
  const bool is_trunk = root == WaistRoot::kTrunk;
  std::string urdf = ReadConfigText(shipped / "generic_humanoid.urdf");
  urdf = internal::Without(urdf, "  <joint name=\"waist_yaw\"", "</joint>\n");
  urdf = Edit(urdf, "<parent link=\"pelvis\"/><child link=\"pelvis_imu\"/>",
              "<parent link=\"trunk\"/><child link=\"pelvis_imu\"/>");
  const std::string waist =
      "  <link name=\"waist_mid\"><inertial><mass value=\"1\"/><inertia ixx=\"0.002\" ixy=\"0\" "
      "ixz=\"0\" iyy=\"0.002\" iyz=\"0\" izz=\"0.002\"/></inertial></link>\n" +
      (is_trunk
           ? internal::WaistJoint("waist_pitch", "trunk", "waist_mid", -kHalfWaist_m, "0 1 0") +
                 internal::WaistJoint("waist_yaw", "waist_mid", "pelvis", -kHalfWaist_m, "0 0 1")
           : internal::WaistJoint("waist_yaw", "pelvis", "waist_mid", kHalfWaist_m, "0 0 1") +
                 internal::WaistJoint("waist_pitch", "waist_mid", "trunk", kHalfWaist_m, "0 1 0"));
  folder.Write("generic_humanoid.urdf", Edit(urdf, "</robot>", waist + "</robot>"));
  std::string yaml = ReadConfigText(shipped / "robot.yaml");
  yaml = Edit(yaml, "names: [waist_yaw]", "names: [waist_pitch, waist_yaw]");
  if (is_trunk) {
    yaml = Edit(yaml, "base: pelvis", "base: trunk");
    yaml = Edit(yaml, "base_height_m: 0.811120901320", "base_height_m: 0.931120901320");
  }
  return folder.Write("robot.yaml", yaml);
}

}  // namespace sidestep
