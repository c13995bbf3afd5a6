// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// momentum_observer: a push anywhere on the robot, from what the ground does not explain.
//
//   F = d(m v_C)/dt - m g - sum f_F,      smoothed
//
// Three things keep it honest:
//   a landing    for push_settle_s after a foot has touched down nothing is learned, and what was
//                felt fades with push_decay_s: the shock is over before forces and the belief's
//                velocity agree again
//   a limit      what a frame says is cut at push_limit_ratio of the weight
//   the end      a quicker low-pass of the same force tells when the push is gone, and takes the
//                estimate down with it, which would trail behind by its own time constant
//
// Over one period the change of the believed momentum is compared with the mean of the feet's
// forces in it, which is what the sensors give (SensorFrame::force_torque): momentary forces would
// let a landing's shock pass for a push. What the arms' sensors explain is taken off; the
// rest has no known point of attack and counts as acting at the CoM. Horizontal only: vertically a
// wrong mass would look like a push. Source: De Luca et al., "Collision detection and safe
// reaction...", IROS 2006, in its centroidal form.

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "controller/types/control_params.h"
#include "controller/types/robot_state.h"

namespace sidestep {

class MomentumObserver {
 public:
  /// Observes nothing if EstimatorParams::push_cutoff_hz is 0. `dt_s` is the time between frames.
  MomentumObserver(const EstimatorParams& params, double mass_kg, double dt_s);

  /// Horizontal force (N, in W) of a push that neither feet nor arms explain; empty if it is within
  /// the deadband, or nothing can be said yet. `arms_N` is what the arms' sensors see, `age_s` how
  /// much older the feet's wrenches are than the rest of the state. Call it once a frame, when
  /// v_WC and the feet's wrenches are final. Does not allocate.
  std::optional<Eigen::Vector2d> Update(const Eigen::Vector3d& arms_N, double age_s,
                                        const RobotState& state);

 private:
  /// What ground and arms leave unexplained `age` frames ago, within the limit (N).
  Eigen::Vector2d Unexplained_N(const Eigen::Vector3d& arms_N, std::size_t age,
                                const RobotState& state) const;
  /// Whether a foot has landed within the last push_settle_s.
  bool Settles(const RobotState& state);
  void Learn(const Eigen::Vector2d& unexplained_N);

  EstimatorParams params_;
  double mass_kg_;
  double dt_s_;
  std::vector<Eigen::Vector2d> velocity_mps_;  // of the CoM, horizontal: a ring of the last frames
  std::size_t num_frames_{0};
  std::vector<bool> in_contact_;  // of the feet, at the last frame
  double settle_s_{0.0};          // left
  Eigen::Vector2d force_N_{Eigen::Vector2d::Zero()};
  Eigen::Vector2d quick_N_{Eigen::Vector2d::Zero()};
};

}  // namespace sidestep
