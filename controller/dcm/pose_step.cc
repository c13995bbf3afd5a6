// SPDX-License-Identifier: BSD-3-Clause
#include "controller/dcm/pose_step.h"

#include <algorithm>
#include <cmath>

#include "controller/dcm/support_area.h"
#include "controller/planner/capture_point.h"

namespace sidestep::dcm {
namespace {

// The walk whose times a step has: of one that closes up, the walk's before.
const GaitParams& WalkOf(const StepAhead& step, const GaitSupport& support) {
  const bool closes = step.gait.type != GaitType::kWalk && support.previous.has_value();
  return closes ? *support.previous : step.gait;
}

void BoundOffset(const ControlParams& control, const StepAhead& step, const GaitParams& gait,
                 StepProblem* problem) {
  const Eigen::Vector3d &lower_m = control.mpc.box_lower_m, &upper_m = control.mpc.box_upper_m;
  const double quickest_s =
      std::min(control.planner.timing.least_swing_s, gait.swing_s) + gait.double_support_s;
  const double growth = std::exp(problem->omega_per_s * quickest_s);
  const Interval forward =
      ViableForward({gait.step_length_m + lower_m.x(), gait.step_length_m + upper_m.x()}, growth);
  const Interval inward =
      ViableSideways({std::max(gait.step_width_m + lower_m.y(), control.planner.min_step_width_m),
                      gait.step_width_m + upper_m.y()},
                     growth);
  const bool is_left = step.foot == 0;
  problem->least_offset_m = {forward.least, is_left ? -inward.most : inward.least};
  problem->most_offset_m = {forward.most, is_left ? -inward.least : inward.most};
}

void BoundPlace(const PlannedContact& contact, StepProblem* problem) {
  problem->nominal_step_m = contact.nominal_p_WF.head<2>();
  problem->least_step_m = problem->nominal_step_m + contact.box_lower_m.head<2>();
  problem->most_step_m = problem->nominal_step_m + contact.box_upper_m.head<2>();
}

// In seconds from now: when the support began, the foot's lift-off and its landing.
struct StepTimes {
  double begin_s{0.0};
  double lift_off_s{0.0};
  double landing_s{0.0};
  double delay_s{0.0};  // PosedStep's
};

void BoundTime(const ControlParams& control, const GaitParams& gait, const StepTimes& times,
               StepProblem* problem) {
  const TimingParams& timing = control.planner.timing;
  const auto time_to = [&](double landed_s) { return landed_s + times.delay_s - times.begin_s; };
  problem->elapsed_s = -times.begin_s;
  problem->least_s = problem->longest_s = problem->nominal_s = time_to(times.landing_s);
  const bool is_free =
      control.stepping == Stepping::kDcmQp && times.landing_s > timing.least_rest_s;
  if (!is_free) return;
  const double quickest_s = std::min(timing.least_swing_s, gait.swing_s);
  problem->nominal_s = time_to(times.lift_off_s + gait.swing_s);
  problem->least_s = time_to(std::max(timing.least_rest_s, times.lift_off_s + quickest_s));
  problem->longest_s =
      std::max(problem->least_s, time_to(times.lift_off_s + control.dcm.longest_swing_s));
}

Eigen::Vector2d HeldPressure(const DcmSetup& setup, const RobotState& state, std::size_t stance,
                             const StepProblem& problem) {
  SupportArea sole;
  AddInnerSole(state.feet[stance], setup.vertices_m[stance], setup.control.dcm.sole_share, &sole);
  const double ahead_s = std::max(problem.nominal_s - problem.elapsed_s, setup.tick_s);
  const double growth = std::exp(problem.omega_per_s * ahead_s);
  const Eigen::Vector2d end_m = problem.nominal_step_m + problem.nominal_offset_m;
  return sole.Nearest((growth * problem.dcm_m - end_m) / (growth - 1.0));
}

}  // namespace

std::optional<PosedStep> PoseStep(const DcmSetup& setup, const RobotState& state,
                                  const Eigen::Vector2d& dcm_m, const DcmReference& reference,
                                  const GaitPlanner& planner, Tick now) {
  const GaitSupport& support = planner.support();
  const auto step = StepAheadOf(planner.setup(), support);
  if (!step || now >= step->landing) return std::nullopt;
  const PlannedContact* contact = UpcomingContact(planner.plan(), step->foot, now);
  if (contact == nullptr) return std::nullopt;
  PosedStep posed{*step, *contact, {}, 0.0, false};
  StepProblem& problem = posed.problem;
  const GaitParams& gait = WalkOf(posed.step, support);
  problem.omega_per_s = 1.0 / PendulumTimeConstant_s(setup.com_height_m);
  posed.delay_s = SwitchDelay_s(gait.double_support_s, problem.omega_per_s);
  const auto after = [&](Tick tick) { return SecondsAt(tick - now, setup.tick_s); };
  const double both_s = SecondsAt(step->lift_off - support.tick, setup.tick_s);
  const double begin_s = after(support.tick) + SwitchDelay_s(both_s, problem.omega_per_s);
  const double landing_s = after(step->landing);
  problem.dcm_m = dcm_m;
  BoundPlace(*contact, &problem);
  BoundTime(setup.control, gait, {begin_s, after(step->lift_off), landing_s, posed.delay_s},
            &problem);
  const double rest_s = gait.double_support_s - posed.delay_s;
  problem.nominal_offset_m =
      std::exp(-problem.omega_per_s * rest_s) *
      (reference.DcmAt(landing_s + gait.double_support_s) - contact->adjusted_p_WF.head<2>());
  BoundOffset(setup.control, *step, gait, &problem);
  problem.stance_m = HeldPressure(setup, state, static_cast<std::size_t>(1 - step->foot), problem);
  posed.has_begun = BeganByLanding(support) ? problem.elapsed_s >= 0.0 : now >= step->lift_off;
  return posed;
}

}  // namespace sidestep::dcm
