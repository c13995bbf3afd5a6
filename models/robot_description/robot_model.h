// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// robot_model: the rigid-body model of a robot, as text that MuJoCo compiles.

#include <filesystem>
#include <string>

namespace sidestep {

/// What the file of a robot's model is written in.
enum class ModelLanguage { kMjcf, kUrdf };

/// "MJCF" or "URDF", for messages.
const char* LanguageName(ModelLanguage language);

/// Which shapes of a model take part. Joints, masses and contacts are the same either way, and with
/// half the bodies a step of the iCub takes a quarter less.
enum class ModelDetail {
  kSimulated,  ///< Those that collide.
  kDrawn       ///< Also those that are only looked at.
};

/// The model. Both texts are whole MJCF documents, to be included in a world's; they differ for a
/// URDF only, because an MJCF is taken as it is, but for WithIncluded() and WithServosAsMotors().
struct RobotModel {
  ModelLanguage language{ModelLanguage::kMjcf};
  std::filesystem::path file;  ///< Absolute.
  std::string simulated_mjcf;  ///< ModelDetail::kSimulated.
  std::string drawn_mjcf;      ///< ModelDetail::kDrawn.
  std::string ground_pairs;    ///< UrdfMjcf::ground_pairs; empty for an MJCF.

  const std::string& mjcf(ModelDetail detail) const {
    return detail == ModelDetail::kSimulated ? simulated_mjcf : drawn_mjcf;
  }
};

/// Reads an MJCF file. Throws ConfigError if it can't be read or is beyond CheckMjcfBounds(); one
/// that MuJoCo can't compile is for ReadMjcfNames() to tell.
RobotModel ReadMjcfModel(const std::filesystem::path& file);

}  // namespace sidestep
