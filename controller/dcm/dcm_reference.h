// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// dcm_reference: where the pressure is meant to be from now on, and the DCM's reference to that.
//
// From the support that is on, landing by landing: under the standing foot, and straight over to
// the next one in each double support. Later footholds keep their nominal distance from the next
// one, wherever that has been put. Backwards from where that ends follows the DCM.

#include <Eigen/Core>
#include <array>
#include <optional>

#include "controller/dcm/pendulum.h"
#include "controller/planner/gait_planner.h"
#include "controller/planner/step_ahead.h"

namespace sidestep::dcm {

/// The contact of `foot` that is to come after `tick`; null if the plan has none.
const PlannedContact* UpcomingContact(const ContactPlan& plan, int foot, Tick tick);

/// Whether the support began with a landing; else it has been standing.
bool BeganByLanding(const GaitSupport& support);

/// A value: copies go on alike. Horizontal, in W; times from now on.
class DcmReference {
 public:
  DcmReference(double omega_per_s, double tick_s) : omega_per_s_(omega_per_s), tick_s_(tick_s) {}

  /// Lays it out anew from the feet of the belief and the planner's schedule at `now`. Does not
  /// allocate.
  void LayOut(const RobotState& state, const GaitPlanner& planner, Tick now);

  /// Where the pressure is meant to be now (m).
  Eigen::Vector2d pressure_m() const { return path_.At(0.0); }

  /// The DCM's reference `ahead_s` from now (m).
  Eigen::Vector2d DcmAt(double ahead_s) const { return path_.DcmAt(ahead_s, end_m_, omega_per_s_); }

 private:
  using Feet = std::array<Eigen::Vector2d, 2>;

  double After(Tick tick) const { return SecondsAt(tick - now_, tick_s_); }
  void AddRest(const GaitSupport& support, const Feet& feet, std::optional<Tick> until);
  void AddStep(const GaitSupport& support, const StepAhead& step, const Feet& feet);

  double omega_per_s_;
  double tick_s_;
  Tick now_{0};
  VrpPath path_;
  Eigen::Vector2d end_m_{Eigen::Vector2d::Zero()};  // of the DCM, where the path ends
};

}  // namespace sidestep::dcm
