// SPDX-License-Identifier: BSD-3-Clause
#include "models/mjcf/base_joints.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "models/mjcf/quaternion.h"
#include "models/support/config_error.h"

namespace sidestep {
namespace {

using Vector3Map = Eigen::Map<Eigen::Vector3d>;
using ConstVector3Map = Eigen::Map<const Eigen::Vector3d>;

constexpr std::array<int, 6> kFreeAxes{0, 1, 2, 3, 4, 5};
constexpr std::array<int, 3> kSagittalAxes{0, 2, 4};
constexpr std::array<int, 3> kAllOfThree{0, 1, 2};
constexpr std::array<int, 2> kAlongPlane{0, 2};
constexpr std::array<int, 1> kAcrossPlane{1};

// Of axes that the MJCF's text gives: MuJoCo normalises them.
constexpr double kRounding = 1e-12;

// What a sagittal base has, in this order.
struct PlaneJoint {
  mjtJoint type;
  Eigen::Vector3d axis;
  const char* words;
};
const std::array<PlaneJoint, 3>& PlaneJoints() {
  static const std::array<PlaneJoint, 3> kJoints{
      {{mjJNT_SLIDE, Eigen::Vector3d::UnitX(), "a slide along 1 0 0"},
       {mjJNT_SLIDE, Eigen::Vector3d::UnitZ(), "a slide along 0 0 1"},
       {mjJNT_HINGE, Eigen::Vector3d::UnitY(), "a hinge about 0 1 0"}}};
  return kJoints;
}

std::string JointName(const mjModel& model, int joint) {
  const char* name = mj_id2name(&model, mjOBJ_JOINT, joint);
  if (name != nullptr) return "joint '" + std::string(name) + "'";
  const int place = joint - model.body_jntadr[model.jnt_bodyid[joint]];
  return "joint number " + std::to_string(place + 1);
}

// What of a joint of the base hinders its motion; empty if nothing does.
std::string Hindrance(const mjModel& model, int joint) {
  const int dof = model.jnt_dofadr[joint];
  const int num_dofs = model.jnt_type[joint] == mjJNT_FREE ? 6 : 1;
  const auto has_any = [&](const mjtNum* of_dof) {
    return std::any_of(of_dof + dof, of_dof + dof + num_dofs, [](mjtNum x) { return x != 0.0; });
  };
  if (model.jnt_limited[joint] != 0) return "a range";
  if (model.jnt_stiffness[joint] != 0.0) return "a stiffness";
  if (has_any(model.dof_damping)) return "a damping";
  if (has_any(model.dof_frictionloss)) return "a frictionloss";
  if (has_any(model.dof_armature)) return "an armature";
  for (int actuator = 0; actuator < model.nu; ++actuator) {
    const int type = model.actuator_trntype[actuator];
    const bool is_on_joint = type == mjTRN_JOINT || type == mjTRN_JOINTINPARENT;
    if (is_on_joint && model.actuator_trnid[2 * actuator] == joint) return "an actuator";
  }
  return {};
}

// Whether the body's joints leave it the plane y = 0: empty, or what does not.
std::string PlaneFault(const mjModel& model, int body) {
  const int first = model.body_jntadr[body];
  const int count = model.body_jntnum[body];
  for (int i = 0; i < std::min(count, 3); ++i) {
    const int joint = first + i;
    const PlaneJoint& wanted = PlaneJoints()[static_cast<std::size_t>(i)];
    if (model.jnt_type[joint] != wanted.type ||
        (ConstVector3Map(model.jnt_axis + 3 * joint) - wanted.axis).norm() >= kRounding) {
      return JointName(model, joint) + " of a base that moves in a plane must be " + wanted.words +
             " (1 0 0, 0 0 1 and the hinge, in this order)";
    }
    if (ConstVector3Map(model.jnt_pos + 3 * joint).norm() >= kRounding) {
      return JointName(model, joint) + " must go through the body's origin";
    }
    if (model.qpos0[model.jnt_qposadr[joint]] != 0.0) {
      return JointName(model, joint) + " must have no ref";
    }
  }
  if (count != 3) {
    return "it has " + std::to_string(count) + " joints, not a free one or the three of a plane";
  }
  const Eigen::Vector4d unturned(1.0, 0.0, 0.0, 0.0);
  if (Eigen::Map<const Eigen::Vector4d>(model.body_quat + 4 * body) != unturned) {
    return "the body must not be turned where the MJCF has it";
  }
  if (model.body_pos[3 * body + 1] != 0.0) return "the body must be at y = 0 in the MJCF";
  return {};
}

double PitchOf(const Eigen::Quaterniond& q) { return 2.0 * std::atan2(q.y(), q.w()); }

Eigen::Quaterniond FromPitch(double pitch_rad) {
  return {std::cos(0.5 * pitch_rad), 0.0, std::sin(0.5 * pitch_rad), 0.0};
}

// What is in the plane: x and z of what points, y of what turns.
void KeepInPlane(Eigen::Vector3d* polar, Eigen::Vector3d* axial) {
  polar->y() = 0.0;
  *axial = {0.0, axial->y(), 0.0};
}

}  // namespace

std::string BaseFault(const mjModel& model, int body) {
  if (body <= 0 || model.body_parentid[body] != 0) return "it is no child of the world";
  const int count = model.body_jntnum[body];
  if (count == 0) return "it has no joints";
  const int first = model.body_jntadr[body];
  if (model.jnt_type[first] != mjJNT_FREE) {
    const std::string fault = PlaneFault(model, body);
    if (!fault.empty()) return fault;
  }
  for (int joint = first; joint < first + count; ++joint) {
    const std::string hindrance = Hindrance(model, joint);
    if (hindrance.empty()) continue;
    return JointName(model, joint) + " has " + hindrance + ", and nothing may hinder a base";
  }
  return {};
}

std::optional<BaseFreedom> BaseFreedomOf(const mjModel& model, int body) {
  if (!BaseFault(model, body).empty()) return {};
  const bool is_free = model.jnt_type[model.body_jntadr[body]] == mjJNT_FREE;
  return is_free ? BaseFreedom::kFree : BaseFreedom::kSagittal;
}

BaseJoints::BaseJoints(const mjModel& model, int body, const std::string& source) {
  const std::optional<BaseFreedom> freedom = BaseFreedomOf(model, body);
  if (!freedom) {
    throw ConfigError(source + ": error: '" + mj_id2name(&model, mjOBJ_BODY, body) +
                      "' can't be the base: " + BaseFault(model, body));
  }
  freedom_ = *freedom;
  const int joint = model.body_jntadr[body];
  position_ = model.jnt_qposadr[joint];
  velocity_ = model.jnt_dofadr[joint];
  origin_m_ = ConstVector3Map(model.body_pos + 3 * body);
}

std::span<const int> BaseJoints::axes() const {
  return is_sagittal() ? std::span<const int>(kSagittalAxes) : std::span<const int>(kFreeAxes);
}

std::span<const int> BaseJoints::linear_axes() const {
  return is_sagittal() ? std::span<const int>(kAlongPlane) : std::span<const int>(kAllOfThree);
}

std::span<const int> BaseJoints::angular_axes() const {
  return is_sagittal() ? std::span<const int>(kAcrossPlane) : std::span<const int>(kAllOfThree);
}

void BaseJoints::Write(const BaseMotion& motion, mjData* data) const {
  mjtNum* qpos = data->qpos + position_;
  mjtNum* qvel = data->qvel + velocity_;
  if (is_sagittal()) {
    qpos[0] = motion.p_WB.x() - origin_m_.x();
    qpos[1] = motion.p_WB.z() - origin_m_.z();
    qpos[2] = PitchOf(motion.q_WB);
    qvel[0] = motion.v_WB.x();
    qvel[1] = motion.v_WB.z();
    qvel[2] = motion.w_WB_B.y();
    return;
  }
  Vector3Map(qpos + 0) = motion.p_WB;
  ToMuJoCo(motion.q_WB, qpos + 3);
  Vector3Map(qvel + 0) = motion.v_WB;
  Vector3Map(qvel + 3) = motion.w_WB_B;
}

BaseMotion BaseJoints::Read(const mjtNum* qpos, const mjtNum* qvel) const {
  const mjtNum* position = qpos + position_;
  const mjtNum* velocity = qvel + velocity_;
  if (is_sagittal()) {
    return {{origin_m_.x() + position[0], 0.0, origin_m_.z() + position[1]},
            FromPitch(position[2]),
            {velocity[0], 0.0, velocity[1]},
            {0.0, velocity[2], 0.0}};
  }
  return {ConstVector3Map(position), FromMuJoCo(position + 3), ConstVector3Map(velocity),
          ConstVector3Map(velocity + 3)};
}

void BaseJoints::Project(BaseMotion* motion) const {
  if (!is_sagittal()) return;
  motion->p_WB.y() = 0.0;
  motion->q_WB = FromPitch(PitchOf(motion->q_WB));
  KeepInPlane(&motion->v_WB, &motion->w_WB_B);
}

void BaseJoints::Project(CentroidalMotion* motion) const {
  if (!is_sagittal()) return;
  motion->p_WC.y() = 0.0;
  KeepInPlane(&motion->v_WC, &motion->angular_momentum);
}

void BaseJoints::ProjectWrench(Eigen::Vector3d* force, Eigen::Vector3d* moment) const {
  if (is_sagittal()) KeepInPlane(force, moment);
}

}  // namespace sidestep
