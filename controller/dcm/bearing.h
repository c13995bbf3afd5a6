// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// bearing: how the robot bears on the ground now: the pressure that a DCM off its reference asks
// for, as far as the soles reach, the CoM's motion under it, and the soles' forces.

#include <Eigen/Core>
#include <array>
#include <vector>

#include "controller/dcm/dcm_reference.h"
#include "controller/dcm/dcm_setup.h"
#include "controller/dcm/support_area.h"
#include "controller/types/control_tick.h"

namespace sidestep::dcm {

/// A value: copies go on alike.
class Bearing {
 public:
  /// Throws ContractViolation unless there are two feet, of few vertices.
  explicit Bearing(const DcmSetup& setup);

  /// On the feet that `planner` has standing at `now`, `dcm_m` being the belief's DCM. Does not
  /// allocate.
  void Update(const RobotState& state, const Eigen::Vector2d& dcm_m, const DcmReference& reference,
              const GaitPlanner& planner, Tick now);

  /// CoM as of the last Update(): the belief's own place and speed, at the gait's height, with the
  /// acceleration that the pressure gives it. It tells no angular momentum.
  const ComTarget& com() const { return com_; }

  /// Forces on the vertices of `foot` as of the last Update() (3 x n_v, N, in W); zero where it
  /// does not stand.
  const Eigen::Matrix3Xd& ForceOn(std::size_t foot) const { return force_N_[foot]; }

 private:
  Eigen::Vector2d Pressure(const RobotState& state, const Eigen::Vector2d& dcm_m,
                           const DcmReference& reference) const;
  void ShareOut(const RobotState& state, const Eigen::Vector2d& pressure_m);
  double ShareOfRight(const RobotState& state, const Eigen::Vector2d& pressure_m) const;

  DcmSetup setup_;
  double omega_per_s_;
  std::array<bool, 2> stands_{};
  ComTarget com_;
  std::vector<Eigen::Matrix3Xd> force_N_;
};

}  // namespace sidestep::dcm
