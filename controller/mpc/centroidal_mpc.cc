// SPDX-License-Identifier: BSD-3-Clause
#include "controller/mpc/centroidal_mpc.h"

#include <algorithm>
#include <cmath>

#include "controller/mpc/make_solver.h"
#include "controller/mpc/shifted_guess.h"

namespace sidestep::mpc {

CentroidalMpc::CentroidalMpc(const MpcParams& params, const RobotModel& robot, double tick_s)
    : tick_s_(tick_s),
      latency_ticks_(TickAt(params.latency_s, tick_s)),
      plan_memory_s_(params.plan_memory_s),
      backend_(params.backend),
      options_{params.tolerance, params.max_iterations},
      builder_(params, robot, tick_s),
      solver_(MakeSolver(backend_, options_)) {}

void CentroidalMpc::Solve(const RobotState& state, const ContactPlan& plan,
                          const GridReferences& references, Tick tick) {
  const MpcSolution* guess = Pose(state, plan, references, tick);
  began_cold_ = guess == nullptr;
  const MpcSolution& solution = solver_->Solve(builder_.ocp(), guess);
  report_ = {true,
             solution.status,
             solution.iterations,
             solution.cost,
             solution.constraint_violation,
             solution.kkt_error,
             !IsUsable(solution.status)};
  if (IsUsable(solution.status)) StorePlan(builder_.ocp(), solution);
}

SolverSetup CentroidalMpc::solver_setup() const {
  SolverSetup setup{backend_, options_, std::nullopt};
  if (!began_cold_) setup.guess = guess_;
  return setup;
}

double CentroidalMpc::CostOf(const RobotState& state, const ContactPlan& plan,
                             const GridReferences& references, Tick tick, double ceiling) {
  const MpcSolution* guess = Pose(state, plan, references, tick);
  return solver_->Weigh(builder_.ocp(), guess, ceiling);
}

const MpcSolution* CentroidalMpc::Pose(const RobotState& state, const ContactPlan& plan,
                                       const GridReferences& references, Tick tick) {
  builder_.Build(state, plan, references, tick);
  RememberVelocity(&builder_.ocp(), tick);
  SetPreviousForces(&builder_.ocp(), tick);
  return WarmStart(builder_.ocp());
}

bool CentroidalMpc::Activate(Tick tick) {
  const std::size_t before = active_;
  while (!waiting_.empty()) {
    // The very first plan is taken at once: there is nothing to go on with until it comes of age.
    if (has_plan() && tick < plans_[waiting_.front()].grid.start() + latency_ticks_) break;
    active_ = waiting_.front();
    waiting_.erase(waiting_.begin());
  }
  return active_ != before;
}

int CentroidalMpc::InputAt(const Plan& plan, Tick tick) {
  return std::min(plan.grid.KnotAt(tick), plan.ocp.knots - 1);
}

ComTarget CentroidalMpc::ComAt(Tick tick) const {
  const Plan& plan = Active();
  const MpcSolution& solution = plan.solution;
  const int k = InputAt(plan, tick);
  const double within_s = SecondsAt(tick - plan.grid.TickOf(k), tick_s_);
  const double mass_kg = plan.ocp.mass_kg;
  ComTarget target;
  target.a_WC = (solution.linear_momentum.col(k + 1) - solution.linear_momentum.col(k)) /
                (mass_kg * plan.ocp.StepAt(k));
  const Eigen::Vector3d v_WC = solution.linear_momentum.col(k) / mass_kg;
  target.v_WC = v_WC + within_s * target.a_WC;
  target.p_WC = solution.p_WC.col(k) + within_s * v_WC + 0.5 * within_s * within_s * target.a_WC;
  const Eigen::Matrix3Xd& h = solution.angular_momentum;
  target.angular_momentum_rate_Nm = (h.col(k + 1) - h.col(k)) / plan.ocp.StepAt(k);
  target.angular_momentum = h.col(k) + within_s * target.angular_momentum_rate_Nm;
  return target;
}

const Eigen::Matrix3Xd& CentroidalMpc::ForceAt(std::size_t foot, Tick tick) const {
  const auto k = static_cast<std::size_t>(InputAt(Active(), tick));
  return Active().solution.contacts[foot].force_N[k];
}

double CentroidalMpc::Age_s(Tick tick) const {
  return has_plan() ? SecondsAt(tick - Active().grid.start(), tick_s_) : 0.0;
}

// Knot 1 counts, for that is where the grids agree: knot 0 is in the midst of an input.
const MpcSolution* CentroidalMpc::WarmStart(const CentroidalOcp& ocp) {
  if (newest_ == kNone) return nullptr;
  const Plan& newest = plans_[newest_];
  const int shift = std::max(0, newest.grid.NearestKnot(builder_.grid().TickOf(1)) - 1);
  if (shift >= ocp.knots) return nullptr;  // nothing of the old horizon is left
  ShiftedGuess(newest.ocp, newest.solution, shift, ocp, &guess_);
  return &guess_;
}

void CentroidalMpc::RememberVelocity(CentroidalOcp* ocp, Tick tick) const {
  if (!has_plan() || plan_memory_s_ == 0.0) return;
  const double remembered = std::exp(-Age_s(tick) / plan_memory_s_);
  const Eigen::Vector3d planned = ocp->mass_kg * ComAt(tick).v_WC;
  ocp->initial_linear_momentum += remembered * (planned - ocp->initial_linear_momentum);
}

// A foot that stands and stood when the plan in use was made has a force to change smoothly from.
void CentroidalMpc::SetPreviousForces(CentroidalOcp* ocp, Tick tick) const {
  if (!has_plan()) return;
  const Tick before = std::max(tick - 1, Active().grid.start());
  for (std::size_t foot = 0; foot < ocp->contacts.size(); ++foot) {
    OcpContact& contact = ocp->contacts[foot];
    const int k = InputAt(Active(), before);
    contact.has_previous_force =
        ActivePhase(contact, 0) >= 0 && ActivePhase(Active().ocp.contacts[foot], k) >= 0;
    if (contact.has_previous_force) contact.previous_force_N = ForceAt(foot, before);
  }
}

std::size_t CentroidalMpc::FreeSlot() {
  for (std::size_t slot = 0; slot < plans_.size(); ++slot) {
    const bool is_waiting = std::find(waiting_.begin(), waiting_.end(), slot) != waiting_.end();
    if (slot != active_ && slot != newest_ && !is_waiting) return slot;
  }
  plans_.emplace_back();
  return plans_.size() - 1;
}

void CentroidalMpc::StorePlan(const CentroidalOcp& ocp, const MpcSolution& solution) {
  const std::size_t slot = FreeSlot();
  Plan& plan = plans_[slot];
  plan.grid = builder_.grid();
  plan.ocp = ocp;
  plan.solution = solution;
  plan.footholds.clear();
  for (std::size_t foot = 0; foot < ocp.contacts.size(); ++foot) {
    const auto& phases = ocp.contacts[foot].phases;
    for (std::size_t phase = 0; phase < phases.size(); ++phase) {
      if (phases[phase].fixed) continue;
      plan.footholds.push_back({static_cast<int>(foot), builder_.PlannedIndex(foot, phase),
                                solution.contacts[foot].phase_p_WF[phase]});
    }
  }
  newest_ = slot;
  waiting_.push_back(slot);
}

}  // namespace sidestep::mpc
