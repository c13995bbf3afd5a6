// SPDX-License-Identifier: BSD-3-Clause
#include "controller/estimator/leg_odometry.h"

namespace sidestep {
namespace {

constexpr double kFreeFootVariance_m2 = 100.0;  // a foot in the air may land anywhere
constexpr double kInitialVariance = 1e-6;       // the start is known
constexpr double kGroundNoise_m = 0.002;        // flatness of the floor
constexpr int kPosition = 0, kVelocity = 3, kFeet = 6;

Eigen::Index FootAt(std::size_t foot) { return kFeet + 3 * static_cast<Eigen::Index>(foot); }

}  // namespace

LegOdometry::LegOdometry(const RobotDescription& robot, const EstimatorParams& params, double dt_s,
                         RigidBody* rigid_body)
    : robot_(robot), params_(params), dt_s_(dt_s), rigid_body_(rigid_body) {
  const Eigen::Index size = FootAt(robot.feet.size());
  x_.setZero(size);
  P_.setIdentity(size, size);
  P_ *= kInitialVariance;
  PHt_.setZero(size);
  H_.setZero(size);
  stands_.assign(robot.feet.size(), false);
  state_.feet.resize(robot.feet.size());
  state_.joint_position.setZero(rigid_body->num_actuators());
  state_.joint_velocity.setZero(rigid_body->num_actuators());
  x_.head<3>() = Eigen::Vector3d(0.0, 0.0, robot.base_height_m) + rigid_body->p_BU();
}

const RobotState& LegOdometry::Update(const SensorFrame& frame) {
  const Eigen::Quaterniond q_WU = frame.imu.q_WU.normalized();
  // An accelerometer tells of the time since the frame before, which the first one has not.
  if (has_frame_) Predict(q_WU * frame.imu.accelerometer_mps2 + rigid_body_->gravity_mps2());
  has_frame_ = true;

  // Kinematics relative to the base: the belief's base position and velocity set to zero.
  state_.q_WB = q_WU * rigid_body_->q_BU().conjugate();
  state_.w_WB_B = rigid_body_->q_BU() * frame.imu.gyro_radps;
  state_.joint_position = frame.joint_position;
  state_.joint_velocity = frame.joint_velocity;
  state_.p_WB.setZero();
  state_.v_WB.setZero();
  rigid_body_->Update(state_);
  const Eigen::Vector3d p_BU_W = state_.q_WB * rigid_body_->p_BU();
  const Eigen::Vector3d v_BU_W = state_.q_WB * state_.w_WB_B.cross(rigid_body_->p_BU());

  for (std::size_t i = 0; i < robot_.feet.size(); ++i) {
    const bool touches = frame.feet[i].normal_force_N > params_.contact_threshold_N;
    state_.feet[i].in_contact = touches;
    if (touches != stands_[i]) ReleaseFoot(i);
    stands_[i] = touches;
    if (!touches) continue;
    CorrectFoot(i, rigid_body_->feet()[i].p_WF - p_BU_W, rigid_body_->feet()[i].v_WF - v_BU_W);
  }

  state_.p_WB = x_.segment<3>(kPosition) - p_BU_W;
  state_.v_WB = x_.segment<3>(kVelocity) - v_BU_W;
  rigid_body_->Update(state_);
  rigid_body_->FillDerived(&state_);
  return state_;
}

void LegOdometry::Predict(const Eigen::Vector3d& a_WU) {
  const double dt = dt_s_;
  x_.segment<3>(kPosition) += dt * x_.segment<3>(kVelocity) + 0.5 * dt * dt * a_WU;
  x_.segment<3>(kVelocity) += dt * a_WU;
  // P <- F P F^T + Q with F = I but for dt at (position, velocity).
  P_.topRows<3>() += dt * P_.middleRows<3>(kVelocity);
  P_.leftCols<3>() += dt * P_.middleCols<3>(kVelocity);
  const double accelerometer_variance =
      params_.accelerometer_noise_mps2 * params_.accelerometer_noise_mps2;
  P_.diagonal().segment<3>(kPosition).array() += 0.25 * dt * dt * dt * dt * accelerometer_variance;
  P_.diagonal().segment<3>(kVelocity).array() += dt * dt * accelerometer_variance;
  const double slip_m = params_.foot_slip_noise_mps * dt;
  for (std::size_t i = 0; i < stands_.size(); ++i) {
    if (stands_[i]) P_.diagonal().segment<3>(FootAt(i)).array() += slip_m * slip_m;
  }
}

void LegOdometry::ReleaseFoot(std::size_t foot) {
  const Eigen::Index at = FootAt(foot);
  P_.middleRows<3>(at).setZero();
  P_.middleCols<3>(at).setZero();
  P_.diagonal().segment<3>(at).setConstant(kFreeFootVariance_m2);
}

void LegOdometry::CorrectFoot(std::size_t foot, const Eigen::Vector3d& p_UF_W,
                              const Eigen::Vector3d& v_UF_W) {
  const Eigen::Index at = FootAt(foot);
  const double position_variance = params_.foot_position_noise_m * params_.foot_position_noise_m;
  const double velocity_variance =
      params_.foot_velocity_noise_mps * params_.foot_velocity_noise_mps;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    H_.setZero();
    H_[kPosition + axis] = -1.0;
    H_[at + axis] = 1.0;
    CorrectScalar(H_, p_UF_W[axis] - (x_[at + axis] - x_[kPosition + axis]), position_variance);
    H_.setZero();
    H_[kVelocity + axis] = 1.0;
    CorrectScalar(H_, -v_UF_W[axis] - x_[kVelocity + axis], velocity_variance);
  }
  H_.setZero();
  H_[at + 2] = 1.0;
  CorrectScalar(H_, robot_.feet[foot].sole_height_m - x_[at + 2], kGroundNoise_m * kGroundNoise_m);
}

void LegOdometry::CorrectScalar(const Eigen::Ref<const Eigen::RowVectorXd>& H, double innovation,
                                double variance) {
  PHt_.noalias() = P_ * H.transpose();
  const double innovation_variance = H.dot(PHt_) + variance;
  x_ += PHt_ * (innovation / innovation_variance);
  P_.noalias() -= (PHt_ / innovation_variance) * PHt_.transpose();
}

}  // namespace sidestep
