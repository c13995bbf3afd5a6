// SPDX-License-Identifier: BSD-3-Clause
#include "models/mjcf/base_joints.h"

#include <array>
#include <cmath>

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

bool IsJoint(const mjModel& model, int joint, mjtJoint type, const Eigen::Vector3d& axis) {
  return model.jnt_type[joint] == type &&
         (ConstVector3Map(model.jnt_axis + 3 * joint) - axis).norm() < kRounding &&
         ConstVector3Map(model.jnt_pos + 3 * joint).norm() < kRounding &&
         model.qpos0[model.jnt_qposadr[joint]] == 0.0;
}

bool IsSagittal(const mjModel& model, int body) {
  const int first = model.body_jntadr[body];
  const Eigen::Vector4d unturned(1.0, 0.0, 0.0, 0.0);
  return model.body_jntnum[body] == 3 &&
         IsJoint(model, first, mjJNT_SLIDE, Eigen::Vector3d::UnitX()) &&
         IsJoint(model, first + 1, mjJNT_SLIDE, Eigen::Vector3d::UnitZ()) &&
         IsJoint(model, first + 2, mjJNT_HINGE, Eigen::Vector3d::UnitY()) &&
         Eigen::Map<const Eigen::Vector4d>(model.body_quat + 4 * body) == unturned &&
         model.body_pos[3 * body + 1] == 0.0;
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

std::optional<BaseFreedom> BaseFreedomOf(const mjModel& model, int body) {
  if (body <= 0 || model.body_parentid[body] != 0 || model.body_jntnum[body] == 0) return {};
  if (model.jnt_type[model.body_jntadr[body]] == mjJNT_FREE) return BaseFreedom::kFree;
  if (IsSagittal(model, body)) return BaseFreedom::kSagittal;
  return {};
}

BaseJoints::BaseJoints(const mjModel& model, int body, const std::string& source) {
  const std::optional<BaseFreedom> freedom = BaseFreedomOf(model, body);
  if (!freedom) {
    throw ConfigError(source + ": error: the base '" + mj_id2name(&model, mjOBJ_BODY, body) +
                      "' must be a child of the world with a free joint or, at y = 0 and not "
                      "turned, with slides along x and z and a hinge about y, in this order");
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
