// SPDX-License-Identifier: BSD-3-Clause
#include "controller/estimator/external_wrench.h"

#include "controller/estimator/low_pass.h"

namespace sidestep {

ExternalWrench::ExternalWrench(ExternalWrenchKnowledge knowledge, const EstimatorParams& params,
                               double mass_kg, double dt_s)
    : knowledge_(knowledge),
      params_(params),
      dt_s_(dt_s),
      observer_(std::in_place, params, mass_kg, dt_s) {}

ExternalWrench::ExternalWrench(ExternalWrenchKnowledge knowledge) : knowledge_(knowledge) {}

void ExternalWrench::Update(const SensorFrame& frame, const Wrench& arms, RobotState* state) {
  switch (knowledge_) {
    case ExternalWrenchKnowledge::kUnknown:
      state->external_wrench = {};
      return;
    case ExternalWrenchKnowledge::kKnown:
      state->external_wrench = frame.known_external_wrench.value_or(Wrench{});
      return;
    case ExternalWrenchKnowledge::kEstimated:
      state->external_wrench = observer_ ? Estimate(frame, arms, *state) : Wrench{};
      return;
  }
}

Wrench ExternalWrench::Estimate(const SensorFrame& frame, const Wrench& arms,
                                const RobotState& state) {
  const double share = LowPassShare(params_.wrench_cutoff_hz, dt_s_);
  smooth_arms_.force_N += share * (arms.force_N - smooth_arms_.force_N);
  smooth_arms_.torque_Nm += share * (arms.torque_Nm - smooth_arms_.torque_Nm);
  Wrench wrench;
  if (smooth_arms_.force_N.norm() > params_.wrench_deadband_N) wrench = smooth_arms_;
  const std::optional<Eigen::Vector2d> push_N =
      observer_->Update(smooth_arms_.force_N, frame.force_torque_age_s, state);
  if (push_N) wrench.force_N.head<2>() += *push_N;
  return wrench;
}

}  // namespace sidestep
