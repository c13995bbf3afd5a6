// SPDX-License-Identifier: BSD-3-Clause
#include "controller/dcm/dcm_reference.h"

#include <algorithm>

#include "controller/planner/gait_generator.h"

namespace sidestep::dcm {
namespace {

constexpr int kLandings = 5;        // e^(-wT) of what is beyond is left: nothing after five steps
constexpr double kPrepare_s = 0.6;  // before a walk begins: three pendulum time constants
constexpr double kSettle_s = 0.2;   // from the last foot to between the feet, once they stand

int NewestFoot(const GaitSupport& support) {
  return support.feet[0].nominal.sequence > support.feet[1].nominal.sequence ? 0 : 1;
}

Eigen::Vector2d Middle(const std::array<Eigen::Vector2d, 2>& feet) {
  return 0.5 * (feet[0] + feet[1]);
}

}  // namespace

const PlannedContact* UpcomingContact(const ContactPlan& plan, int foot, Tick tick) {
  for (const PlannedContact& contact : plan.feet[static_cast<std::size_t>(foot)]) {
    if (contact.start_tick > tick) return &contact;
  }
  return nullptr;
}

bool BeganByLanding(const GaitSupport& support) {
  const auto newest = static_cast<std::size_t>(NewestFoot(support));
  return support.tick > 0 && support.feet[newest].nominal.contact.start_tick == support.tick;
}

void DcmReference::LayOut(const RobotState& state, const GaitPlanner& planner, Tick now) {
  now_ = now;
  path_.Clear();
  Feet feet{state.feet[0].p_WF.head<2>(), state.feet[1].p_WF.head<2>()};
  Eigen::Vector2d off_m = Eigen::Vector2d::Zero();
  std::optional<GaitSupport> support = planner.support();
  for (int landings = 0; landings < kLandings;) {
    const auto next = NextSupport(planner.setup(), *support);
    const auto step = StepAheadOf(planner.setup(), *support);
    if (!next || !step) {
      AddRest(*support, feet, next ? std::optional<Tick>(next->tick) : std::nullopt);
      end_m_ = Middle(feet);
      if (!next) return;
      ++landings;
    } else {
      AddStep(*support, *step, feet);
      const auto foot = static_cast<std::size_t>(step->foot);
      const Eigen::Vector2d nominal_m = next->feet[foot].nominal.contact.nominal_p_WF.head<2>();
      const PlannedContact* contact = UpcomingContact(planner.plan(), step->foot, now_);
      if (landings++ == 0 && contact != nullptr) {
        off_m = contact->adjusted_p_WF.head<2>() - nominal_m;
      }
      feet[foot] = nominal_m + off_m;
      end_m_ = Middle(feet);
    }
    support = next;
  }
  path_.Add(path_.end_s() + kSettle_s, Middle(feet));
}

void DcmReference::AddRest(const GaitSupport& support, const Feet& feet,
                           std::optional<Tick> until) {
  double begin_s = After(support.tick);
  if (BeganByLanding(support)) {
    path_.Add(begin_s, feet[static_cast<std::size_t>(1 - NewestFoot(support))]);
    begin_s += kSettle_s;
  }
  path_.Add(begin_s, Middle(feet));
  if (until) path_.Add(std::max(begin_s, After(*until) - kPrepare_s), Middle(feet));
}

void DcmReference::AddStep(const GaitSupport& support, const StepAhead& step, const Feet& feet) {
  const Eigen::Vector2d& stance_m = feet[static_cast<std::size_t>(1 - step.foot)];
  if (BeganByLanding(support)) {
    path_.Add(After(support.tick), feet[static_cast<std::size_t>(1 - NewestFoot(support))]);
  }
  path_.Add(After(step.lift_off), stance_m);
  path_.Add(After(step.landing), stance_m);
}

}  // namespace sidestep::dcm
