// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// base_joints: which ways a robot's base may move, and how MuJoCo counts them.
//
//   free      a free joint                                    qpos: p_WB, q_WB    6 velocities
//   sagittal  slides along x and z, a hinge about y, in this   qpos: x, z, pitch   3 velocities
//             order, in the world's axes: the plane y = 0
//
// Velocity r of the base is component axes()[r] of the spatial [v_WB (in W); w_WB_B (in B)], row r
// of the equation of motion the same component of the wrench [force (in W); moment about B's origin
// (in B)]. Who loops over axes() needs no case of its own for the plane.

#include <mujoco/mujoco.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <optional>
#include <span>
#include <string>

#include "models/mjcf/centroidal_motion.h"

namespace sidestep {

enum class BaseFreedom { kFree, kSagittal };

/// A base's motion in space, whatever joints give it.
struct BaseMotion {
  Eigen::Vector3d p_WB{Eigen::Vector3d::Zero()};  ///< m.
  Eigen::Quaterniond q_WB{Eigen::Quaterniond::Identity()};
  Eigen::Vector3d v_WB{Eigen::Vector3d::Zero()};    ///< m/s, of B's origin, in W.
  Eigen::Vector3d w_WB_B{Eigen::Vector3d::Zero()};  ///< rad/s, in B.
};

/// [linear; angular].
using Vector6 = Eigen::Matrix<double, 6, 1>;

/// Why `body` of the model can't float, in words that follow "'<body>' can't be the base: ". Empty
/// if it can: a child of the world with a free joint, or with the plane's three, at y = 0, not
/// turned, all through its origin. Nothing but gravity and contact acts on a base, so its joints
/// have neither range, stiffness, damping, friction, armature nor actuator.
std::string BaseFault(const mjModel& model, int body);

/// How `body` of the model floats; empty where BaseFault() is not.
std::optional<BaseFreedom> BaseFreedomOf(const mjModel& model, int body);

/// The joints of one base. A value; nothing allocates.
class BaseJoints {
 public:
  /// Throws ConfigError, `<source>: error: ...`, where BaseFreedomOf() is empty.
  BaseJoints(const mjModel& model, int body, const std::string& source);

  BaseFreedom freedom() const { return freedom_; }
  bool is_sagittal() const { return freedom_ == BaseFreedom::kSagittal; }
  int num_velocities() const { return static_cast<int>(axes().size()); }

  /// Ascending, linear ones first; see above.
  std::span<const int> axes() const;
  /// Which of x, y, z the robot moves along and which it turns about: 0 to 2, as many of the first
  /// as there are linear rows.
  std::span<const int> linear_axes() const;
  std::span<const int> angular_axes() const;
  int num_linear() const { return static_cast<int>(linear_axes().size()); }

  /// Writes the base's part of qpos and qvel. What the base can't do is left out, as Project()
  /// does.
  void Write(const BaseMotion& motion, mjData* data) const;

  /// The motion that qpos and qvel hold.
  BaseMotion Read(const mjData& data) const { return Read(data.qpos, data.qvel); }
  BaseMotion Read(const mjtNum* qpos, const mjtNum* qvel) const;

  /// `motion` without what the base can't do: nothing of a free one; of a sagittal one y, v_y, yaw,
  /// roll and their rates. The pitch that stays is the nearest.
  void Project(BaseMotion* motion) const;

  /// Of a robot that moves in a plane the CoM is in it, and its momenta are those of the plane.
  /// Legs that swing side by side have a yaw momentum besides, which the plane's guide bears.
  void Project(CentroidalMotion* motion) const;

  /// The same for a force and its moment, in W: what the plane's guide bears is left out.
  void ProjectWrench(Eigen::Vector3d* force, Eigen::Vector3d* moment) const;

  /// The base's velocities (or rows), spread over the six components: zero where there is none.
  template <typename Derived>
  Vector6 Spread(const Eigen::MatrixBase<Derived>& generalised) const {
    Vector6 spread = Vector6::Zero();
    Eigen::Index row = 0;
    for (const int axis : axes()) spread[axis] = generalised[row++];
    return spread;
  }

 private:
  BaseFreedom freedom_;
  int position_{0};           // in qpos
  int velocity_{0};           // in qvel
  Eigen::Vector3d origin_m_;  // of a sagittal base at qpos = 0, in W
};

}  // namespace sidestep
