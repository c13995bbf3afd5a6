// SPDX-License-Identifier: BSD-3-Clause
#include "controller/estimator/truth_estimator.h"

#include "models/support/require.h"

namespace sidestep {

TruthEstimator::TruthEstimator(const RobotDescription& robot, const EstimatorParams& params,
                               double dt_s, RigidBody* rigid_body)
    : rigid_body_(rigid_body),
      forces_(robot, params, dt_s, rigid_body),
      observer_(params, rigid_body->mass_kg(), dt_s) {
  state_.feet.resize(rigid_body->feet().size());
  state_.joint_position.setZero(rigid_body->num_actuators());
  state_.joint_velocity.setZero(rigid_body->num_actuators());
}

const RobotState& TruthEstimator::Update(const SensorFrame& frame) {
  SIDESTEP_REQUIRE(frame.truth.has_value(), "the frame carries no truth");
  state_.p_WB = frame.truth->p_WB;
  state_.q_WB = frame.truth->q_WB;
  state_.v_WB = frame.truth->v_WB;
  state_.w_WB_B = frame.truth->w_WB_B;
  state_.joint_position = frame.joint_position;
  state_.joint_velocity = frame.joint_velocity;
  rigid_body_->UpdateKinematics(state_);
  rigid_body_->FillDerived(&state_);
  forces_.Update(frame, &state_);
  forces_.NoteVelocity(rigid_body_->velocity());
  observer_.Update(forces_.arms().force_N, frame.force_torque_age_s, &state_);
  return state_;
}

CentroidalEstimator::CentroidalEstimator(int num_feet, double mass_kg, double contact_threshold_N)
    : mass_kg_(mass_kg), contact_threshold_N_(contact_threshold_N) {
  state_.feet.resize(static_cast<std::size_t>(num_feet));
}

const RobotState& CentroidalEstimator::Update(const SensorFrame& frame) {
  SIDESTEP_REQUIRE(frame.centroidal.has_value(), "the frame carries no centroidal sample");
  const CentroidalSample& sample = *frame.centroidal;
  state_.p_WC = sample.p_WC;
  state_.v_WC = sample.linear_momentum / mass_kg_;
  state_.angular_momentum = sample.angular_momentum;
  state_.p_WB = state_.p_WC;
  state_.v_WB = state_.v_WC;
  for (std::size_t i = 0; i < state_.feet.size(); ++i) {
    state_.feet[i].p_WF = sample.p_WF[i];
    state_.feet[i].in_contact = frame.feet[i].normal_force_N > contact_threshold_N_;
  }
  return state_;
}

}  // namespace sidestep
