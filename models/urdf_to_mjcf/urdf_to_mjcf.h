// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// urdf_to_mjcf: a humanoid's URDF, and what a URDF can't say, as the MJCF text that MuJoCo loads.
//
// In : URDF of boxes, spheres and cylinders; UrdfConversion.    Out: MJCF text, to be included.
// What becomes of what:
//   link with mass            body; under a fixed joint a body welded to its parent
//   link without mass         site of the same name on the body that it is fixed to; so an F/T
//                             sensor, an IMU, a sole or a hand is a link without mass
//   revolute, continuous,     hinge or slide with the URDF's range, one motor each, in the order of
//   prismatic joint           UrdfConversion::joints
//   cylinder                  capsule of the same overall length where it is longer than wide, as
//                             round ends look and collide better; else a cylinder
//   collision shape           touches the floor; touches other shapes only if a pair of
//                             self_collision says so; drawn only if its link has no visual shape
//   visual shape              geom on an unnamed, massless body welded to its link's
//   collision mesh            left out, with a notice; an error if a foot has no other shape
//   visual mesh               drawn, if it is in mesh_folders and MuJoCo can: see mesh_file.h
//   link with nothing to see  sticks to the joints on it, or the box of its inertia: see looks.h
//
// Force/torque sensors. MuJoCo measures between a body and its parent. A sensor whose link is fixed
// to a body without `distal` sits between that body and its parent. With `distal` it sits inside
// the body: the distal part becomes a body `<name>_distal` of its own, welded to what remains,
// with the named joints and shapes; the rest keeps the difference of mass, first and second moment,
// so the robot as a whole stays as it was. Sensors are `<name>_force` and `<name>_torque`, in the
// sensor's frame, about its origin. Their sign is MuJoCo's and can't be turned in an MJCF: what the
// proximal part does to the distal one, so that a standing foot reads a force downwards (measured
// with MuJoCo 2.2.2, pinned by a test). Who reads them for SensorFrame, which wants what the distal
// part does to the proximal one, negates.

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "models/support/file_notes.h"
#include "models/urdf_to_mjcf/mass_properties.h"

namespace sidestep {

struct UrdfTree;  // read_urdf.h

/// A joint with a motor.
struct UrdfActuator {
  std::string joint;
  double torque_limit_Nm{0.0};  ///< > 0; N for a slide.
  double armature_kgm2{0.0};    ///< Reflected inertia of the rotor.
  double damping_Nms_per_rad{0.0};
};

/// What a force/torque sensor inside a link has on its far side.
struct UrdfDistalPart {
  MassProperties mass;              ///< In the link's frame; less than the link's.
  std::vector<std::string> joints;  ///< Joints of the link that move to the part.
  std::vector<std::string> shapes;  ///< Names of visual and collision shapes that move to the part.
};

struct UrdfForceTorque {
  std::string name;                      ///< Of the link without mass that is its frame.
  std::optional<UrdfDistalPart> distal;  ///< Absent: all of the link that it is fixed to.
};

/// Every collision shape of the first links against every one of the second.
using UrdfCollisionGroups = std::array<std::vector<std::string>, 2>;

/// What a URDF doesn't say.
struct UrdfConversion {
  std::string imu;                         ///< Link without mass.
  std::vector<std::string> foot_frames;    ///< Links without mass; see FootDescription.
  std::vector<UrdfActuator> actuators;     ///< Every moving joint but the locked, each once.
  std::vector<std::string> locked_joints;  ///< Welded at zero.
  std::vector<UrdfForceTorque> force_torque;
  std::vector<UrdfCollisionGroups> self_collision;
  /// Where meshes to look at may lie, with all below; no other file is read.
  std::vector<std::filesystem::path> mesh_folders;
  bool has_visuals{true};  ///< Whether visual shapes, which do not collide, come along.
};

/// What a URDF becomes.
struct UrdfMjcf {
  std::string robot;  ///< A whole document, to be included.
  /// `<pair>`s of kGroundGeom with every collision shape. With them in its `<contact>` and
  /// `collision="predefined"` a world finds the same contacts as by MuJoCo's search.
  std::string ground_pairs;
};

/// A joint that moves, with what the URDF says of its motor (0 where it says nothing).
struct UrdfJointInfo {
  std::string name;
  double effort_Nm{0.0};
  double velocity_radps{0.0};
  double damping_Nms_per_rad{0.0};
  /// Why it can't move here and must be locked ("mimics ...", "moves link ... without mass"), to
  /// follow "joint 'x' "; empty if it can.
  std::string fault{};
  TextPlace place{};  ///< In the URDF.
};

/// A link with mass.
struct UrdfLinkInfo {
  std::string name;
  MassProperties mass;              ///< In the link's frame.
  std::vector<std::string> joints;  ///< Moving joints on it, or on a link without mass fixed to it.
  std::vector<std::string>
      shapes;  ///< Names of its visual and collision shapes, without empty ones.
};

/// A link without mass.
struct UrdfFrameInfo {
  std::string name;
  std::string link;  ///< With mass, that it is fixed to.
};

/// What a URDF calls its parts.
struct UrdfParts {
  std::vector<UrdfLinkInfo> links;  ///< The base first, then parents before children.
  std::vector<UrdfJointInfo> joints;
  std::vector<UrdfFrameInfo> frames;
};

/// Reads a URDF for its names, whatever of it may be locked. Throws ConfigError as SurveyUrdf().
UrdfParts ReadUrdfParts(const std::filesystem::path& urdf);

/// SurveyUrdf() with all that there is to say of the file for a conversion with these locked
/// joints, foot frames and mesh folders, and what it is drawn with.
UrdfTree SurveyFor(const std::filesystem::path& urdf, const UrdfConversion& conversion);

/// Converts what SurveyFor() read. Throws as UrdfToMjcf().
UrdfMjcf Convert(UrdfTree tree, const std::string& name, const UrdfConversion& conversion);

/// Converts. The base is the URDF's first link with mass; it gets a free joint.
/// Throws ConfigError with all of the problems that SurveyFor() noted, and ContractViolation if
/// `conversion` does not fit the URDF: check its names, motors and distal masses against UrdfParts,
/// where a user's file tells the place.
UrdfMjcf UrdfToMjcf(const std::filesystem::path& urdf, const UrdfConversion& conversion);

}  // namespace sidestep
