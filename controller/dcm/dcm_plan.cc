// SPDX-License-Identifier: BSD-3-Clause
#include "controller/dcm/dcm_plan.h"

#include "controller/planner/capture_point.h"
#include "controller/planner/schedule_edits.h"

namespace sidestep::dcm {

DcmPlan::DcmPlan(const DcmSetup& setup)
    : setup_(setup),
      omega_per_s_(1.0 / PendulumTimeConstant_s(setup.com_height_m)),
      qp_(setup.control.dcm),
      reference_(omega_per_s_, setup.tick_s),
      bearing_(setup),
      told_(1) {}

void DcmPlan::Update(const RobotState& state, const Eigen::Vector3d& momentum, Tick tick,
                     GaitPlanner* planner) {
  const Eigen::Vector2d dcm_m = (state.p_WC + state.v_WC / omega_per_s_).head<2>();
  reference_.LayOut(state, *planner, tick);
  DecideOnStep(state, dcm_m, tick, planner);
  reference_.LayOut(state, *planner, tick);
  bearing_.Update(state, dcm_m, reference_, *planner, tick);
  com_ = bearing_.com();
  com_.angular_momentum = momentum;
}

void DcmPlan::DecideOnStep(const RobotState& state, const Eigen::Vector2d& dcm_m, Tick tick,
                           GaitPlanner* planner) {
  qp_status_ = QpStatus::kNotSolved;
  const auto posed = PoseStep(setup_, state, dcm_m, reference_, *planner, tick);
  if (!posed || !posed->has_begun) return;
  const bool is_qp = setup_.control.stepping == Stepping::kDcmQp;
  const StepDecision decision =
      is_qp ? qp_.Solve(posed->problem) : CapturePointStep(posed->problem);
  if (is_qp) qp_status_ = decision.status;
  if (decision.status != QpStatus::kSolved) return;
  decision_ = decision;
  const double ahead_s = decision.time_s - posed->problem.elapsed_s - posed->delay_s;
  Tell(*posed, is_qp ? tick + TickAt(ahead_s, setup_.tick_s) : posed->step.landing, tick, planner);
}

void DcmPlan::Tell(const PosedStep& posed, Tick landing, Tick tick, GaitPlanner* planner) {
  const PlannedContact& contact = posed.contact;
  told_[0] = {posed.step.foot, contact.index, contact.nominal_p_WF};
  told_[0].p_WF.head<2>() = decision_.step_m;
  if (landing != posed.step.landing) {
    const TouchDownMove move{planner->support().sequence + 1, landing - posed.step.landing};
    const auto moved = MoveTouchDown(planner->setup(), planner->support(), tick, move, 1);
    if (moved) planner->Adopt(*moved);
  }
  planner->AdoptFootholds(told_);
}

}  // namespace sidestep::dcm
