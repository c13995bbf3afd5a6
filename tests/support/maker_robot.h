// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// maker_robot: URDFs as makers of humanoids write them, with what makes them hard to take.

#include <filesystem>
#include <string>

namespace sidestep {

/// What a foot can touch the ground with.
/// kMarks: spheres of radius 0, which mark the sole's corners.
enum class MakerFoot { kBox, kSpheres, kMarks, kMesh, kNone };

/// A humanoid of ours with two legs of six joints, a waist, two arms and a neck.
struct MakerRobot {
  std::string name{"maker"};
  double size{1.0};  ///< Of its lengths: 1.5 m tall at 1; its mass goes with the third power.
  MakerFoot foot{MakerFoot::kBox};
  bool is_rooted_in_trunk{false};   ///< The waist's joint then points downwards.
  bool has_mesh_shapes{false};      ///< Thighs, shanks and trunk collide as meshes/*.stl.
  bool has_floating_root{false};    ///< A world without mass, and a floating joint.
  bool has_fingers{false};          ///< A finger a hand moves, another mimics it.
  bool has_gram_frames{false};      ///< A fixed camera of 5 g without inertia, an IMU frame.
  bool has_wild_limits{false};      ///< Efforts of 1e9, no velocities.
  bool bends_hips_first{false};     ///< Hips in the order pitch, roll, yaw; knees bend at zero.
  bool is_drawn_from_floor{false};  ///< The pelvis' frame is on the floor, between the feet.
  bool has_odd_names{false};        ///< A blank behind the trunk's, a colon in the knees'.
  int leg_joints{6};                ///< 5: no ankle roll.
};

/// The URDF's text.
std::string UrdfOf(const MakerRobot& robot);

/// Writes NAME.urdf and the meshes it refers to into `folder`; returns the URDF's path.
std::filesystem::path WriteMakerRobot(const MakerRobot& robot, const std::filesystem::path& folder);

/// Writes a box as a binary STL. @param size_m  Edges; its middle is at `middle_m`.
void WriteBoxStl(const std::filesystem::path& file, const double (&size_m)[3],
                 const double (&middle_m)[3]);

}  // namespace sidestep
