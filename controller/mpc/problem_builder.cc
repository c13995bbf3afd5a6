// SPDX-License-Identifier: BSD-3-Clause
#include "controller/mpc/problem_builder.h"

#include <algorithm>
#include <cmath>

#include "controller/types/friction_pyramid.h"

namespace sidestep::mpc {

ProblemBuilder::ProblemBuilder(const MpcParams& params, const RobotModel& robot, double tick_s)
    : params_(params), tick_s_(tick_s), step_ticks_(TickAt(params.step_s, tick_s)) {
  const int knots = params.knots;
  ocp_.step_s = params.step_s;
  ocp_.knots = knots;
  ocp_.mass_kg = robot.mass_kg;
  ocp_.gravity_mps2 = robot.gravity_mps2;
  ocp_.foot_load_limit_N = params.foot_load_ratio * robot.mass_kg * robot.gravity_mps2.norm();
  ocp_.weights = params.weights;
  ocp_.friction_A = FrictionPyramid(params.friction);
  ocp_.friction_b = Eigen::VectorXd::Zero(ocp_.friction_A.rows());
  ocp_.external_force_N.setZero(3, knots);
  ocp_.external_torque_Nm.setZero(3, knots);
  ocp_.contacts.resize(robot.vertices_m.size());
  planned_.resize(robot.vertices_m.size());
  for (std::size_t foot = 0; foot < robot.vertices_m.size(); ++foot) {
    OcpContact& contact = ocp_.contacts[foot];
    contact.name = robot.foot_names[foot];
    contact.vertices_m = robot.vertices_m[foot];
    if (!robot.legs.empty()) {
      contact.leg = robot.legs[foot];
      contact.leg.length_m *= params.leg_stretch;
    }
    if (!robot.force_shares.empty()) contact.force_shares = robot.force_shares[foot];
    contact.previous_force_N.setZero(3, contact.vertices_m.cols());
    contact.phases.reserve(static_cast<std::size_t>(knots) + 1);
    planned_[foot].reserve(static_cast<std::size_t>(knots) + 1);
  }
}

const CentroidalOcp& ProblemBuilder::Build(const RobotState& state, const ContactPlan& plan,
                                           const GridReferences& references, Tick tick) {
  grid_ = GridAt(plan, tick);
  // A first knot of T is none of its own: in seconds it might differ from T by rounding.
  ocp_.first_step_s.reset();
  if (grid_.StepAt(0) < step_ticks_) ocp_.first_step_s = SecondsAt(grid_.StepAt(0), tick_s_);
  ocp_.initial_p_WC = state.p_WC;
  ocp_.initial_linear_momentum = ocp_.mass_kg * state.v_WC;
  ocp_.initial_angular_momentum = state.angular_momentum;
  ocp_.reference_p_WC = references.p_WC;
  ocp_.reference_angular_momentum = references.angular_momentum;
  FillExternalWrench(state.external_wrench);
  for (std::size_t foot = 0; foot < plan.feet.size(); ++foot) {
    ocp_.contacts[foot].has_previous_force = false;
    FillPhases(foot, plan.feet[foot]);
  }
  return ocp_;
}

void ProblemBuilder::FillPhases(std::size_t foot, const std::vector<PlannedContact>& planned) {
  auto& phases = ocp_.contacts[foot].phases;
  phases.clear();
  planned_[foot].clear();
  const Tick last_tick = grid_.TickOf(params_.knots + 1);
  for (const PlannedContact& contact : planned) {
    ContactPhase phase;
    phase.first_knot = grid_.NearestKnot(std::min(contact.start_tick, last_tick));
    phase.end_knot = grid_.NearestKnot(std::min(contact.end_tick, last_tick));
    if (phase.end_knot <= phase.first_knot || phase.first_knot > params_.knots) continue;
    phase.fixed = contact.start_tick <= grid_.start();
    phase.R_WF = contact.R_WF;
    phase.p_WF = contact.adjusted_p_WF;
    phase.nominal_p_WF = contact.nominal_p_WF;
    phase.box_lower_m = contact.box_lower_m;
    phase.box_upper_m = contact.box_upper_m;
    phases.push_back(phase);
    planned_[foot].push_back(contact.index);
  }
}

// A knot gets the mean over its time.
void ProblemBuilder::FillExternalWrench(const Wrench& wrench) {
  const double hold_s = params_.external_wrench_hold_s, decay_s = params_.external_wrench_decay_s;
  for (int k = 0; k < params_.knots; ++k) {
    const double step_s = ocp_.StepAt(k);
    const double start_s = grid_.StepsTo(k) * params_.step_s;
    double share = std::clamp((hold_s - start_s) / step_s, 0.0, 1.0);
    if (decay_s > 0.0) {  // the integral of exp(-t / decay_s) over what is left of the knot
      const double from_s = std::max(start_s - hold_s, 0.0);
      const double to_s = std::max(start_s + step_s - hold_s, 0.0);
      share += decay_s / step_s * (std::exp(-from_s / decay_s) - std::exp(-to_s / decay_s));
    }
    ocp_.external_force_N.col(k) = share * wrench.force_N;
    ocp_.external_torque_Nm.col(k) = share * wrench.torque_Nm;
  }
}

}  // namespace sidestep::mpc
