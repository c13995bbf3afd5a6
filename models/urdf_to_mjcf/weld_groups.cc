// SPDX-License-Identifier: BSD-3-Clause
#include "models/urdf_to_mjcf/weld_groups.h"

#include <algorithm>
#include <functional>
#include <sstream>

#include "models/urdf_to_mjcf/read_urdf.h"
#include "models/urdf_to_mjcf/urdfdom_model.h"

namespace sidestep {
namespace {

std::string RangeText(const urdf::JointLimits& limits) {
  std::ostringstream text;
  text << "from " << limits.lower << " to " << limits.upper;
  return text.str();
}

}  // namespace

bool WeldGroups::IsPointMass(const urdf::Link& link) {
  const MassProperties mass = MassOf(link);
  return mass.mass_kg > 0.0 && mass.mass_kg <= kMaxPointMass_kg && !IsPhysical(mass);
}

bool WeldGroups::HasBody(const urdf::Link& link) {
  return link.inertial && link.inertial->mass != 0.0 && !IsPointMass(link);
}

std::optional<Carrier> WeldGroups::CarrierOf(const urdf::Link& top) {
  std::optional<Carrier> best;
  int num_candidates = 0;
  const std::function<void(const urdf::Link&, const Eigen::Isometry3d&)> visit =
      [&](const urdf::Link& link, const Eigen::Isometry3d& X_TL) {
        if (HasBody(link)) {
          ++num_candidates;
          if (!best || link.inertial->mass > best->link->inertial->mass) best = {&link, X_TL, 0};
          return;
        }
        for (const urdf::JointSharedPtr& joint : link.child_joints) {
          if (!IsWeld(*joint)) continue;
          visit(Child(*joint), X_TL * FromUrdf(joint->parent_to_joint_origin_transform));
        }
      };
  visit(top, Eigen::Isometry3d::Identity());
  if (best) best->num_candidates = num_candidates;
  return best;
}

const std::string& WeldGroups::Fault(const urdf::Joint& joint) {
  const auto known = faults_.find(joint.name);
  if (known != faults_.end()) return known->second;
  return faults_.emplace(joint.name, FindFault(joint)).first->second;
}

std::string WeldGroups::FindFault(const urdf::Joint& joint) {
  if (joint.type == urdf::Joint::FIXED) return "";
  const bool is_hinge =
      joint.type == urdf::Joint::REVOLUTE || joint.type == urdf::Joint::CONTINUOUS;
  if (!is_hinge && joint.type != urdf::Joint::PRISMATIC) {
    return "is neither fixed, revolute, continuous nor prismatic";
  }
  if (joint.mimic) return "mimics '" + joint.mimic->joint_name + "', which can't be simulated";
  const bool has_range = joint.type != urdf::Joint::CONTINUOUS && joint.limits;
  if (has_range && joint.limits->lower >= joint.limits->upper) {
    return "has no range to move in, " + RangeText(*joint.limits);
  }
  const urdf::Link& child = Child(joint);
  if (CarrierOf(child)) return "";
  if (!IsPointMass(child)) {
    return "moves a link without mass, '" + child.name + "', to which none with mass is fixed";
  }
  return "moves link '" + child.name + "', which " + WhyNotPhysical(MassOf(child));
}

bool WeldGroups::IsLocked(const urdf::Joint& joint) const {
  return std::find(locked_joints_.begin(), locked_joints_.end(), joint.name) !=
         locked_joints_.end();
}

bool WeldGroups::IsWeld(const urdf::Joint& joint) {
  return joint.type == urdf::Joint::FIXED || IsLocked(joint) || !Fault(joint).empty();
}

const urdf::Joint* WeldGroups::FloatingJoint() const {
  std::vector<const urdf::Joint*> moving;
  std::vector<const urdf::Link*> links{model_.getRoot().get()};
  while (!links.empty()) {
    const urdf::Link& link = *links.back();
    links.pop_back();
    if (link.inertial && link.inertial->mass != 0.0) return nullptr;
    for (const urdf::JointSharedPtr& joint : link.child_joints) {
      if (joint->type == urdf::Joint::FIXED) {
        links.push_back(&Child(*joint));
      } else {
        moving.push_back(joint.get());
      }
    }
  }
  const bool floats = moving.size() == 1 && moving[0]->type == urdf::Joint::FLOATING;
  return floats ? moving[0] : nullptr;
}

}  // namespace sidestep
