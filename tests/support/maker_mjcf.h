// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// maker_mjcf: MJCFs as makers of humanoids write them: a scene of its own around a robot in another
// file, classes of defaults, words newer than our MuJoCo.

#include <filesystem>
#include <string>

namespace sidestep {

enum class MjcfFoot { kBoxes, kBalls, kCapsules };
enum class MjcfActuators { kMotors, kPositions, kGenerals };

/// A humanoid of ours of some 54 kg, 1.5 m tall, with a waist, two legs of six joints and two arms.
struct MakerMjcf {
  MjcfFoot foot{MjcfFoot::kBoxes};
  MjcfActuators actuators{MjcfActuators::kMotors};
  bool shares_hips{false};  ///< A thigh has all three joints of its hip, a foot both of its ankle.
  bool has_newer_words{false};
  bool is_fixed{false};  ///< Without a free joint.
  double armature_kgm2{0.04};
  bool has_head{true};  ///< With a neck that moves.
};

/// The robot alone. Without has_newer_words our MuJoCo takes it as it is.
std::string RobotMjcf(const MakerMjcf& robot);

/// Writes NAME.xml, the scene with its floor, lights and keyframe, and what it includes into
/// `folder`; returns the scene's path.
std::filesystem::path WriteMakerMjcf(const MakerMjcf& robot, const std::string& name,
                                     const std::filesystem::path& folder);

}  // namespace sidestep
