// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// weld_groups: which links of a URDF are one body: links without mass and what is fixed to them.

#include <urdf_model/model.h>

#include <Eigen/Geometry>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace sidestep {

/// The link that gives a weld group its body.
struct Carrier {
  const urdf::Link* link;
  Eigen::Isometry3d X_LC;  ///< Its pose in the group's top link.
  int num_candidates;      ///< Links with mass that hang on the same links without mass.
};

/// Asks of a URDF's links and joints while some joints are locked.
class WeldGroups {
 public:
  /// Both must outlive this.
  WeldGroups(const urdf::ModelInterface& model, const std::vector<std::string>& locked_joints)
      : model_(model), locked_joints_(locked_joints) {}

  const urdf::Link& Child(const urdf::Joint& joint) const {
    return *model_.links_.at(joint.child_link_name);
  }

  /// Whether the link weighs a few grams without the inertia of a body: see kMaxPointMass_kg.
  static bool IsPointMass(const urdf::Link& link);

  /// Whether the link can be a body of its own, if only because its mass is a problem.
  static bool HasBody(const urdf::Link& link);

  /// `top` itself if it HasBody(), else the heaviest (the first of equals) of those that hang on it
  /// by welds, through links without a body. Nothing if there are none.
  std::optional<Carrier> CarrierOf(const urdf::Link& top);

  /// Why the joint can't move, as UrdfJointInfo::fault; empty for a fixed one.
  const std::string& Fault(const urdf::Joint& joint);

  bool IsLocked(const urdf::Joint& joint) const;

  /// Fixed, locked or unable to move.
  bool IsWeld(const urdf::Joint& joint);

  /// The joint that lets all but links without mass float in the world, if there is one: the only
  /// joint that moves on the top links.
  const urdf::Joint* FloatingJoint() const;

 private:
  std::string FindFault(const urdf::Joint& joint);

  const urdf::ModelInterface& model_;
  const std::vector<std::string>& locked_joints_;
  std::map<std::string, std::string> faults_;  ///< By joint: each is asked for often.
};

}  // namespace sidestep
