// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// read_urdf: a URDF file as a tree of bodies with mass.
//
// What stands between a public URDF and a robot is of three kinds:
//   unreadable   bad XML, numbers, names, a graph that is no tree, too large: SurveyUrdf() throws
//   problem      an impossible inertia, no base, a moving joint that can't move and isn't locked:
//                UrdfTree::notes has them all; ReadUrdf() throws them
//   harmless     left out or mended, and told in UrdfTree::notes as notices
// Harmless are colours without names, what only other programs read, a world link on a floating
// joint, links without mass (frames) anywhere but alone at the end of a joint, welded links of a
// few grams with an impossible inertia (point masses).

#include <filesystem>
#include <string>
#include <vector>

#include "models/support/file_notes.h"
#include "models/urdf_to_mjcf/body_tree.h"
#include "models/urdf_to_mjcf/urdf_to_mjcf.h"

namespace sidestep {

/// A welded link of at most this mass may have no inertia, or an impossible one: that of a camera's
/// or sensor's frame is often made up, and its mass at a point makes no difference.
inline constexpr double kMaxPointMass_kg = 0.02;

/// The tree under the base, and what the URDF says of the motors.
struct UrdfTree {
  Body base;
  std::vector<UrdfJointInfo> joints;  ///< That move, locked ones among them; parents first.
  FileNotes notes;
};

/// Reads the file. Joints called in `locked_joints`, and those with a `fault`, become welds at
/// zero. Links without mass become frames of the body that they are fixed to, or of the heaviest
/// link fixed to them where none is above: that is how the base is found. Of shapes that are meshes
/// only the name is read. Problems stay in UrdfTree::notes, and the tree is then good for looking
/// at only. Throws ConfigError, a line `file:line:column: error: ...` for all that is unreadable.
UrdfTree SurveyUrdf(const std::filesystem::path& urdf,
                    const std::vector<std::string>& locked_joints);

/// Notes every joint with a fault that is not among `locked_joints` as a problem.
void NoteFaultyJoints(const std::vector<std::string>& locked_joints, UrdfTree* tree);

/// Notes meshes that should collide, all in one: a problem where a foot (what carries one of
/// `foot_frames`, with all that is welded to it) has no other shape, else a notice.
void NoteMeshCollisions(const std::vector<std::string>& foot_frames, UrdfTree* tree);

/// SurveyUrdf() without problems: throws ConfigError with all of them.
UrdfTree ReadUrdf(const std::filesystem::path& urdf, const std::vector<std::string>& locked_joints);

}  // namespace sidestep
