// SPDX-License-Identifier: BSD-3-Clause
#include "controller/estimator/truth_estimator.h"

#include "models/support/require.h"

namespace sidestep {

TruthEstimator::TruthEstimator(const RobotDescription& robot, const EstimatorParams& params,
                               ExternalWrenchKnowledge external_wrench, double dt_s,
                               const RigidBody& body)
    : forces_(robot, params, dt_s, body),
      external_wrench_(external_wrench, params, body.mass_kg(), dt_s) {
  state_.feet.resize(body.num_feet());
  state_.joint_position.setZero(body.num_actuators());
  state_.joint_velocity.setZero(body.num_actuators());
}

std::unique_ptr<StateEstimator> TruthEstimator::Clone() const {
  return std::make_unique<TruthEstimator>(*this);
}

const RobotState& TruthEstimator::Update(const SensorFrame& frame, RigidBody* body) {
  SIDESTEP_REQUIRE(frame.truth.has_value(), "the frame carries no truth");
  state_.p_WB = frame.truth->p_WB;
  state_.q_WB = frame.truth->q_WB;
  state_.v_WB = frame.truth->v_WB;
  state_.w_WB_B = frame.truth->w_WB_B;
  state_.joint_position = frame.joint_position;
  state_.joint_velocity = frame.joint_velocity;
  body->Project(&state_);
  body->Update(state_);
  body->FillDerived(&state_);
  forces_.Update(frame, body, &state_);
  forces_.NoteVelocity(body->velocity());
  external_wrench_.Update(frame, forces_.arms(), &state_);
  body->Project(&state_);
  return state_;
}

CentroidalEstimator::CentroidalEstimator(int num_feet, double mass_kg, double contact_threshold_N,
                                         ExternalWrenchKnowledge external_wrench)
    : mass_kg_(mass_kg),
      contact_threshold_N_(contact_threshold_N),
      external_wrench_(external_wrench) {
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
  external_wrench_.Update(frame, Wrench{}, &state_);
  return state_;
}

}  // namespace sidestep
