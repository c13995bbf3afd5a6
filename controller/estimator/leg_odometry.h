// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// leg_odometry: a Kalman filter of base and footholds from the IMU and the legs' encoders.
//
// Attitude and angular rate come from the IMU, by way of the joints between it and the base; which
// feet stand is what force sensing says. The filter's state is
//   x = [p_WU, v_WU, p_WF_1 .. p_WF_n]     (IMU position and velocity, footholds; all in W)
// predicted with the accelerometer, corrected by a standing foot's kinematics: the foot is where
// its foothold is, and the point on which it rests (resting_point.h) does not move and is on flat
// ground. With the resting point P and the foot's angular velocity w_WF, both felt,
//   v_WF = -w_WF x p_FP,   and the foothold, which is F's place, moves with it.
// P is not known well, so that a sole's velocity is doubted the more the faster it turns.
//
// Of a base that moves in a plane the belief never leaves it: what IMU and filter say across it is
// noise, and is left out (RigidBody::Project). Along the plane nothing differs.
//
// Source: Bloesch et al., "State estimation for legged robots", RSS 2012, with the attitude taken
// as known, which makes the filter linear.

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "controller/estimator/external_wrench.h"
#include "controller/estimator/force_sensing.h"
#include "controller/estimator/state_estimator.h"
#include "controller/model/rigid_body.h"
#include "controller/types/control_params.h"

namespace sidestep {

/// Position along the floor drifts with every step, and yaw is the IMU's own; height does not
/// drift, for standing feet are on the floor. On a frame without a standing foot it only predicts.
/// Starts at the robot's home pose, which it takes as known.
class LegOdometry final : public StateEstimator {
 public:
  /// `dt_s` is the time between frames; `body` is the robot, whose home pose is where the base
  /// starts.
  LegOdometry(const RobotDescription& robot, const EstimatorParams& params,
              ExternalWrenchKnowledge external_wrench, double dt_s, const RigidBody& body);

  const RobotState& Update(const SensorFrame& frame, RigidBody* body) override;
  std::unique_ptr<StateEstimator> Clone() const override;

 private:
  /// Base attitude and rate, base at the origin and at rest.
  void OrientBase(const Eigen::Quaterniond& q_WU, const Eigen::Vector3d& w_WU_U, RigidBody* body);
  /// One dt_s under a constant acceleration of the IMU (m/s^2, in W, gravity taken off).
  void Predict(const Eigen::Vector3d& a_WU);
  /// Forgets a foothold, on landing as on lift-off: it may be anywhere.
  void ReleaseFoot(std::size_t foot);
  /// Notes a foot in the air that is off the ground on which it last stood.
  void WatchLift(std::size_t foot, const Eigen::Vector3d& p_UF_W);
  /// How the foot turns on the ground since the frame before, which takes its foothold along.
  void TurnFoot(std::size_t foot, bool has_stood);
  /// What is known of the floor where a foot lands: it may be off by floor_noise_m. Said once a
  /// foothold, for a foot that bounces is back on the same ground; and the less the farther off the
  /// ground is found to be, for then it is a hole or a step and not that floor.
  void ExpectFloor(std::size_t foot, const Eigen::Vector3d& p_UF_W);
  /// By the foot's place and velocity relative to the IMU, in W, axis by axis.
  void CorrectFoot(std::size_t foot, const Eigen::Vector3d& p_UF_W, const Eigen::Vector3d& v_UF_W);
  /// One measurement z = H x + noise: no matrix is inverted.
  void CorrectScalar(const Eigen::Ref<const Eigen::RowVectorXd>& H, double innovation,
                     double variance);

  /// A standing foot's motion about the point on which it rests.
  struct Turn {
    Eigen::Vector3d p_FP{Eigen::Vector3d::Zero()};  ///< In W (m).
    Eigen::Vector3d v_WF{Eigen::Vector3d::Zero()};  ///< Of F, were P at rest (m/s).
    double doubt{1.0};                              ///< Factor of the velocities' deviations.
  };

  RobotDescription robot_;
  EstimatorParams params_;
  double dt_s_;
  ForceSensing forces_;
  ExternalWrench external_wrench_;
  Eigen::VectorXd x_;         // 6 + 3 n
  Eigen::MatrixXd P_;         // its covariance
  Eigen::VectorXd PHt_;       // scratch
  Eigen::RowVectorXd H_;      // scratch
  std::vector<bool> stands_;  // at the last frame
  std::vector<bool> lifted_;  // since it last stood: its next foothold is a new one
  std::vector<Turn> turns_;   // likewise, of feet that stood
  bool has_frame_{false};
  RobotState state_;
};

}  // namespace sidestep
