// SPDX-License-Identifier: BSD-3-Clause
#include "models/urdf_to_mjcf/read_urdf.h"

#include <algorithm>
#include <utility>

#include "models/urdf_to_mjcf/urdf_document.h"
#include "models/urdf_to_mjcf/urdf_elements.h"
#include "models/urdf_to_mjcf/urdf_graph.h"
#include "models/urdf_to_mjcf/urdfdom_model.h"
#include "models/urdf_to_mjcf/weld_groups.h"

namespace sidestep {
namespace {

std::string Listed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

/// Builds the tree of a URDF that is one.
class TreeReader {
 public:
  TreeReader(const urdf::ModelInterface& model, const std::vector<std::string>& locked_joints,
             UrdfDocument* document)
      : model_(model),
        groups_(model, locked_joints),
        document_(*document),
        tree_{{}, {}, document->notes()} {}

  UrdfTree Read() {
    const urdf::Link* top = model_.getRoot().get();
    if (const urdf::Joint* floating = groups_.FloatingJoint()) {
      tree_.notes.Notice(document_.Place("joint", floating->name),
                         "joint '" + floating->name +
                             "' is taken as the base's freedom to float, "
                             "and link '" +
                             top->name + "' as the world");
      top = &groups_.Child(*floating);
    }
    const std::optional<Carrier> carrier = groups_.CarrierOf(*top);
    if (!carrier) {
      tree_.notes.Problem(document_.Place("link", top->name),
                          "link '" + top->name +
                              "' at the root has no mass, and no link with mass is fixed to it: "
                              "give the robot's trunk or pelvis an <inertial>");
    } else if (carrier->link != top && top->child_joints.size() > 1) {
      const std::string which = carrier->num_candidates > 1 ? "the heaviest" : "the one with mass";
      tree_.notes.Notice(document_.Place("link", top->name),
                         "link '" + top->name + "' at the root has no mass; the base is '" +
                             carrier->link->name + "', " + which + " of the links fixed to it");
    }
    tree_.base = BodyOf(*top, carrier.value_or(Carrier{top, Eigen::Isometry3d::Identity(), 0}));
    NoticePoints();
    return std::move(tree_);
  }

 private:
  static Eigen::Isometry3d PoseOf(const urdf::Joint& joint) {
    return FromUrdf(joint.parent_to_joint_origin_transform);
  }

  /// The body of the weld group under `top`, with all that hangs on it.
  Body BodyOf(const urdf::Link& top, const Carrier& carrier) {
    const urdf::Link& link = *carrier.link;
    Body body;
    body.name = link.name;
    body.mass = MassOf(link);
    if (const std::string why = WhyNotPhysical(body.mass);
        !why.empty() && WeldGroups::HasBody(link)) {
      tree_.notes.Problem(document_.Place("link", link.name, "inertial"),
                          "link '" + link.name + "' " + why + "; mend its <inertial>");
    }
    const bool is_top = &link == &top;
    AddGroup(top, is_top ? Eigen::Isometry3d::Identity() : carrier.X_LC.inverse(), link, &body);
    return body;
  }

  /// Adds what `link`, fixed to `body` with the pose X_BL, is, has and carries.
  void AddGroup(const urdf::Link& link, const Eigen::Isometry3d& X_BL, const urdf::Link& carrier,
                Body* body) {
    if (&link != &carrier) {
      body->frames.push_back({link.name, X_BL});
      if (WeldGroups::IsPointMass(link)) AddPoint(link, X_BL, body);
    }
    for (Shape& shape : ShapesOf(link, X_BL, document_)) body->shapes.push_back(std::move(shape));
    for (const urdf::JointSharedPtr& joint : link.child_joints) {
      const urdf::Link& child = groups_.Child(*joint);
      const Eigen::Isometry3d X_BC = X_BL * PoseOf(*joint);
      AddJointInfo(*joint);
      if (!groups_.IsWeld(*joint)) {
        body->children.push_back(MovingBody(*joint, child, X_BC));
      } else if (&child == &carrier) {
        AddGroup(child, Eigen::Isometry3d::Identity(), carrier, body);
      } else if (!WeldGroups::HasBody(child)) {
        AddGroup(child, X_BC, carrier, body);
      } else {
        Body welded = BodyOf(child, {&child, Eigen::Isometry3d::Identity(), 1});
        welded.X_PB = X_BC;
        body->children.push_back(std::move(welded));
      }
    }
  }

  void AddPoint(const urdf::Link& link, const Eigen::Isometry3d& X_BL, Body* body) {
    MassProperties point = MassOf(link);
    point.inertia_kgm2.setZero();
    body->mass = Together(body->mass, InFrame(X_BL, point));
    if (points_.empty()) first_point_ = document_.Place("link", link.name, "inertial");
    points_.push_back(link.name);
  }

  void NoticePoints() {
    if (points_.empty()) return;
    tree_.notes.Notice(first_point_,
                       "welded links of a few grams with the inertia of no body are taken as point "
                       "masses, and as frames: " +
                           Listed(points_));
  }

  Body MovingBody(const urdf::Joint& joint, const urdf::Link& top, const Eigen::Isometry3d& X_PT) {
    const Carrier carrier = *groups_.CarrierOf(top);  // else the joint had a fault
    Body body = BodyOf(top, carrier);
    body.X_PB = X_PT * carrier.X_LC;
    Joint moving;
    moving.name = joint.name;
    moving.is_slide = joint.type == urdf::Joint::PRISMATIC;
    moving.axis << joint.axis.x, joint.axis.y, joint.axis.z;
    moving.has_range = joint.type != urdf::Joint::CONTINUOUS && joint.limits;
    if (moving.has_range) {
      moving.lower = joint.limits->lower;
      moving.upper = joint.limits->upper;
    }
    if (carrier.link != &top) {
      const Eigen::Isometry3d X_BT = carrier.X_LC.inverse();
      moving.axis = X_BT.linear() * moving.axis;
      moving.p_BJ = X_BT.translation();
    }
    body.joint = moving;
    return body;
  }

  void AddJointInfo(const urdf::Joint& joint) {
    if (joint.type == urdf::Joint::FIXED) return;
    UrdfJointInfo info{joint.name};
    info.fault = groups_.Fault(joint);
    info.place = document_.Place("joint", joint.name);
    if (joint.limits) {
      info.effort_Nm = joint.limits->effort;
      info.velocity_radps = joint.limits->velocity;
    }
    if (joint.dynamics) info.damping_Nms_per_rad = joint.dynamics->damping;
    tree_.joints.push_back(info);
  }

  const urdf::ModelInterface& model_;
  WeldGroups groups_;
  const UrdfDocument& document_;
  UrdfTree tree_;
  std::vector<std::string> points_;  ///< Links taken as point masses.
  TextPlace first_point_;
};

}  // namespace

UrdfTree SurveyUrdf(const std::filesystem::path& urdf,
                    const std::vector<std::string>& locked_joints) {
  UrdfDocument document(urdf);
  CheckElements(&document);
  CheckGraph(&document);
  document.notes().ThrowProblems();
  const std::shared_ptr<urdf::ModelInterface> model = ParseUrdf(document, urdf.string());
  return TreeReader(*model, locked_joints, &document).Read();
}

UrdfTree ReadUrdf(const std::filesystem::path& urdf,
                  const std::vector<std::string>& locked_joints) {
  UrdfTree tree = SurveyUrdf(urdf, locked_joints);
  NoteFaultyJoints(locked_joints, &tree);
  tree.notes.ThrowProblems();
  return tree;
}

}  // namespace sidestep
