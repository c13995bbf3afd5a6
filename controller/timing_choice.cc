// SPDX-License-Identifier: BSD-3-Clause
#include "controller/timing_choice.h"

#include <algorithm>
#include <limits>

#include "controller/planner/capture_point.h"

namespace sidestep {
namespace {

TimingLimits LimitsOf(const TimingParams& params, const MpcParams& mpc, double tick_s) {
  return {TickAt(mpc.step_s, tick_s), TickAt(params.least_swing_s, tick_s),
          TickAt(params.least_rest_s, tick_s), TickAt(params.least_support_s, tick_s)};
}

}  // namespace

TimingChoice::TimingChoice(const TimingParams& params, const MpcParams& mpc, double com_height_m,
                           double mass_kg, double tick_s)
    : params_(params),
      mpc_params_(mpc),
      limits_(LimitsOf(params, mpc, tick_s)),
      com_height_m_(com_height_m),
      alarm_(params.error_m, params.alert_s, com_height_m, mass_kg, tick_s),
      tick_s_(tick_s) {}

std::optional<GaitSupport> TimingChoice::Choose(const RobotState& state, const GaitPlanner& planner,
                                                const Eigen::Vector3d& momentum, Tick tick,
                                                mpc::CentroidalMpc* mpc) {
  if (params_.error_m == 0.0) return std::nullopt;
  if (candidates_.capacity() == 0) TakeMemory(planner);
  if (!mpc->has_plan() || !alarm_.Update(state, mpc->ComAt(tick), tick)) return std::nullopt;
  if (ErrorOf(state, planner, tick) < params_.error_m) return std::nullopt;
  ListTimingCandidates(planner.setup(), planner.support(), tick, limits_, &candidates_);
  if (candidates_.empty()) return std::nullopt;
  constexpr double kAnyCost = std::numeric_limits<double>::infinity();
  double least = (1.0 - params_.gain) *
                 CostOf(state, planner.schedule(), planner.plan(), momentum, tick, kAnyCost, mpc);
  std::optional<GaitSupport> chosen;
  for (const GaitSupport& candidate : candidates_) {
    planner.LayOut(candidate, &schedule_);
    GaitPlanner::TakePlan(candidate, schedule_, &plan_);
    const double cost = CostOf(state, schedule_, plan_, momentum, tick, least, mpc);
    if (cost >= least) continue;
    least = cost;
    chosen = candidate;
  }
  return chosen;
}

void TimingChoice::TakeMemory(const GaitPlanner& planner) {
  candidates_.reserve(MostTimingCandidates(planner.setup(), limits_));
  planner.LayOut(planner.support(), &schedule_);
  GaitPlanner::TakePlan(planner.support(), schedule_, &plan_);
}

double TimingChoice::ErrorOf(const RobotState& state, const GaitPlanner& planner, Tick tick) const {
  const Eigen::Vector3d error = CapturePointError(state, planner.ReferenceAt(tick), com_height_m_);
  return std::max(error.norm(), (error + planner.support().shift).norm());
}

double TimingChoice::CostOf(const RobotState& state, const ContactSchedule& schedule,
                            const ContactPlan& plan, const Eigen::Vector3d& momentum, Tick tick,
                            double ceiling, mpc::CentroidalMpc* mpc) {
  SampleReferences(schedule, mpc->GridAt(plan, tick), momentum, mpc_params_, tick_s_, &references_);
  return mpc->CostOf(state, plan, references_, tick, ceiling);
}

}  // namespace sidestep
