// SPDX-License-Identifier: BSD-3-Clause
#include "controller/estimator/leg_odometry.h"

#include <algorithm>
#include <cmath>

#include "controller/estimator/resting_point.h"

namespace sidestep {
namespace {

constexpr double kFreeFootVariance_m2 = 100.0;  // a foot in the air may land anywhere
constexpr double kInitialVariance = 1e-6;       // the start is known
constexpr double kGroundNoise_m = 0.002;        // flatness of the floor
constexpr double kFloorDeviations = 3.0;        // a floor is hardly ever off by more
constexpr double kLifted_m = 0.005;             // bounces are lower, swings higher
constexpr int kPosition = 0, kVelocity = 3, kFeet = 6;

Eigen::Index FootAt(std::size_t foot) { return kFeet + 3 * static_cast<Eigen::Index>(foot); }

}  // namespace

LegOdometry::LegOdometry(const RobotDescription& robot, const EstimatorParams& params,
                         ExternalWrenchKnowledge external_wrench, double dt_s,
                         const RigidBody& body)
    : robot_(robot),
      params_(params),
      dt_s_(dt_s),
      forces_(robot, params, dt_s, body),
      external_wrench_(external_wrench, params, body.mass_kg(), dt_s) {
  const Eigen::Index size = FootAt(robot.feet.size());
  x_.setZero(size);
  P_.setIdentity(size, size);
  P_ *= kInitialVariance;
  PHt_.setZero(size);
  H_.setZero(size);
  stands_.assign(robot.feet.size(), false);
  lifted_.assign(robot.feet.size(), true);
  turns_.resize(robot.feet.size());
  state_.feet.resize(robot.feet.size());
  RigidBody at_home(body);
  at_home.WriteHome(&state_);
  at_home.Update(state_);
  x_.head<3>() = at_home.imu().p_WU;
}

std::unique_ptr<StateEstimator> LegOdometry::Clone() const {
  return std::make_unique<LegOdometry>(*this);
}

const RobotState& LegOdometry::Update(const SensorFrame& frame, RigidBody* body) {
  const Eigen::Quaterniond q_WU = frame.imu.q_WU.normalized();
  // An accelerometer tells of the time since the frame before, which the first one has not.
  if (has_frame_) Predict(q_WU * frame.imu.accelerometer_mps2 + body->gravity_mps2());
  has_frame_ = true;
  state_.joint_position = frame.joint_position;
  state_.joint_velocity = frame.joint_velocity;
  OrientBase(q_WU, frame.imu.gyro_radps, body);

  // Kinematics relative to the base: its position and velocity are zero so far.
  body->FillDerived(&state_);
  forces_.Update(frame, body, &state_);
  const Eigen::Vector3d p_BU_W = body->imu().p_WU;
  const Eigen::Vector3d v_BU_W = body->imu().v_WU;
  for (std::size_t i = 0; i < robot_.feet.size(); ++i) {
    const bool touches = state_.feet[i].in_contact;
    const Eigen::Vector3d p_UF_W = body->feet()[i].p_WF - p_BU_W;
    if (touches != stands_[i]) ReleaseFoot(i);
    if (touches) TurnFoot(i, stands_[i]);
    if (touches && lifted_[i]) ExpectFloor(i, p_UF_W);
    stands_[i] = touches;
    if (touches) {
      CorrectFoot(i, p_UF_W, body->feet()[i].v_WF - v_BU_W);
    } else {
      WatchLift(i, p_UF_W);
    }
  }

  state_.p_WB = x_.segment<3>(kPosition) - p_BU_W;
  state_.v_WB = x_.segment<3>(kVelocity) - v_BU_W;
  body->Project(&state_);
  body->Translate(state_.p_WB, state_.v_WB);
  body->FillDerived(&state_);
  forces_.NoteVelocity(body->velocity());
  external_wrench_.Update(frame, forces_.arms(), &state_);
  body->Project(&state_);
  return state_;
}

// Base attitude and rate from the IMU's, which may ride on another body: what joints turn between
// base and IMU is taken off. Leaves the rigid body at the belief, base at the origin and at rest.
void LegOdometry::OrientBase(const Eigen::Quaterniond& q_WU, const Eigen::Vector3d& w_WU_U,
                             RigidBody* body) {
  state_.p_WB.setZero();
  state_.v_WB.setZero();
  const ImuInBase imu = body->LocateImu(state_);
  state_.q_WB = (q_WU * Eigen::Quaterniond(imu.R_BU.transpose())).normalized();
  state_.w_WB_B = imu.R_BU * w_WU_U - imu.w_BU_B;
  body->Project(&state_);
  body->Update(state_);
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
    const double wander_m = slip_m * turns_[i].doubt;
    if (stands_[i]) P_.diagonal().segment<3>(FootAt(i)).array() += wander_m * wander_m;
  }
}

void LegOdometry::ReleaseFoot(std::size_t foot) {
  const Eigen::Index at = FootAt(foot);
  P_.middleRows<3>(at).setZero();
  P_.middleCols<3>(at).setZero();
  P_.diagonal().segment<3>(at).setConstant(kFreeFootVariance_m2);
}

void LegOdometry::TurnFoot(std::size_t foot, bool has_stood) {
  const FootState& state = state_.feet[foot];
  Turn& turn = turns_[foot];
  const Eigen::Vector3d before_mps = turn.v_WF;
  turn.p_FP = RestingPoint(robot_.feet[foot], state);
  turn.v_WF = -state.w_WF.cross(turn.p_FP);
  const bool is_point = robot_.feet[foot].vertices_m.cols() == 1;  // whose resting point is known
  turn.doubt = is_point ? 1.0 : 1.0 + state.w_WF.norm() / params_.foot_turn_doubt_radps;
  if (has_stood) x_.segment<3>(FootAt(foot)) += 0.5 * dt_s_ * (before_mps + turn.v_WF);
}

// Of a foot in the air the filter's foothold stays where it last stood.
void LegOdometry::WatchLift(std::size_t foot, const Eigen::Vector3d& p_UF_W) {
  const double rise_m = x_[kPosition + 2] + p_UF_W.z() - x_[FootAt(foot) + 2];
  if (rise_m > kLifted_m) lifted_[foot] = true;
}

// Huber's weight: what is off by more deviations than kFloorDeviations pulls no harder than there.
void LegOdometry::ExpectFloor(std::size_t foot, const Eigen::Vector3d& p_UF_W) {
  lifted_[foot] = false;
  if (params_.floor_noise_m == 0.0) return;
  const Eigen::Index height = FootAt(foot) + 2;
  const double floor_m = -turns_[foot].p_FP.z();
  const double variance = params_.floor_noise_m * params_.floor_noise_m;
  const double deviation_m = std::sqrt(P_(kPosition + 2, kPosition + 2) + variance);
  const double off_m = x_[kPosition + 2] + p_UF_W.z() - floor_m;
  x_[height] = floor_m;
  P_(height, height) = variance * std::max(1.0, std::abs(off_m) / (kFloorDeviations * deviation_m));
}

void LegOdometry::CorrectFoot(std::size_t foot, const Eigen::Vector3d& p_UF_W,
                              const Eigen::Vector3d& v_UF_W) {
  const Eigen::Index at = FootAt(foot);
  const double position_variance = params_.foot_position_noise_m * params_.foot_position_noise_m;
  const Turn& turn = turns_[foot];
  const double velocity_noise_mps = turn.doubt * params_.foot_velocity_noise_mps;
  const double velocity_variance = velocity_noise_mps * velocity_noise_mps;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    H_.setZero();
    H_[kPosition + axis] = -1.0;
    H_[at + axis] = 1.0;
    CorrectScalar(H_, p_UF_W[axis] - (x_[at + axis] - x_[kPosition + axis]), position_variance);
    H_.setZero();
    H_[kVelocity + axis] = 1.0;
    CorrectScalar(H_, turn.v_WF[axis] - v_UF_W[axis] - x_[kVelocity + axis], velocity_variance);
  }
  if (params_.floor_noise_m > 0.0) return;  // said once, when it landed
  H_.setZero();
  H_[at + 2] = 1.0;
  CorrectScalar(H_, -turn.p_FP.z() - x_[at + 2], kGroundNoise_m * kGroundNoise_m);
}

void LegOdometry::CorrectScalar(const Eigen::Ref<const Eigen::RowVectorXd>& H, double innovation,
                                double variance) {
  PHt_.noalias() = P_ * H.transpose();
  const double innovation_variance = H.dot(PHt_) + variance;
  x_ += PHt_ * (innovation / innovation_variance);
  P_.noalias() -= (PHt_ / innovation_variance) * PHt_.transpose();
}

}  // namespace sidestep
