// SPDX-License-Identifier: BSD-3-Clause
#include "controller/mpc/structured/structured_solver.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "controller/mpc/problem/solution_shape.h"
#include "controller/mpc/structured/force_limits.h"
#include "controller/mpc/structured/interior_point.h"
#include "controller/mpc/structured/minimize.h"
#include "controller/mpc/structured/structured_memory.h"
#include "controller/mpc/structured/structured_problem.h"
#include "models/support/require.h"

namespace sidestep::mpc {
namespace {

using structured::Outcome;
using structured::ProblemView;

constexpr int kMaxWarmIterations = 50;    // Then a cold start; good guesses take up to 15.
constexpr double kForceTolerance = 1e-9;  // Relative: below what the optimum is compared at.

class StructuredSolver final : public CentroidalSolver {
 public:
  explicit StructuredSolver(const SolverOptions& options) : options_(options) {}

  const MpcSolution& Solve(const CentroidalOcp& ocp, const MpcSolution* guess) override;
  double Weigh(const CentroidalOcp& ocp, const MpcSolution* guess, double ceiling) override;
  std::unique_ptr<CentroidalSolver> Clone() const override {
    return std::make_unique<StructuredSolver>(options_);
  }

 private:
  structured::Settings SettingsOf(bool is_warm, int max_iterations) const;
  structured::Summary Minimize(const CentroidalOcp& ocp, const MpcSolution& start,
                               const structured::Settings& settings);
  int WarmIterations() const { return std::min(options_.max_iterations, kMaxWarmIterations); }
  void Optimise(const CentroidalOcp& ocp, const MpcSolution* guess);
  void Report(const CentroidalOcp& ocp, const structured::Summary& summary);

  SolverOptions options_;
  structured::StructuredProblem problem_;
  structured::Memory memory_;
  structured::Workspace workspace_;
  MpcSolution start_;
  MpcSolution solution_;
};

bool IsDone(const structured::Summary& summary) {
  return summary.outcome == Outcome::kSolved || summary.outcome == Outcome::kAcceptable;
}

bool HasActiveContact(const CentroidalOcp& ocp) {
  return std::any_of(ocp.contacts.begin(), ocp.contacts.end(), [&](const OcpContact& contact) {
    return std::any_of(contact.phases.begin(), contact.phases.end(),
                       [&](const ContactPhase& phase) {
                         return phase.first_knot < ocp.knots && phase.end_knot > 0;
                       });
  });
}

// The dynamics can always be followed, so that only limits without inside make a problem
// infeasible.
bool IsInfeasible(const CentroidalOcp& ocp) {
  return HasEmptyBox(ocp) ||
         (HasActiveContact(ocp) &&
          !structured::HasFeasibleForce(ocp.friction_A, ocp.friction_b, kForceTolerance));
}

const MpcSolution& StructuredSolver::Solve(const CentroidalOcp& ocp, const MpcSolution* guess) {
  CheckShapes(ocp);
  SIDESTEP_REQUIRE(guess == nullptr || HasShape(ocp, *guess), "a guess of other shapes");
  const bool is_finite = IsFinite(ocp);
  const bool is_infeasible = is_finite && IsInfeasible(ocp);
  solution_.iterations = 0;
  if (is_finite && !is_infeasible) {
    Optimise(ocp, guess != nullptr && IsFinite(*guess) ? guess : nullptr);
    return solution_;
  }
  ResetToShape(ocp, &solution_);
  solution_.cost = 0.0;
  solution_.constraint_violation = 0.0;
  solution_.kkt_error = 0.0;
  solution_.status = is_infeasible ? SolveStatus::kInfeasible : SolveStatus::kNumericalError;
  return solution_;
}

double StructuredSolver::Weigh(const CentroidalOcp& ocp, const MpcSolution* guess, double ceiling) {
  CheckShapes(ocp);
  SIDESTEP_REQUIRE(guess == nullptr || HasShape(ocp, *guess), "a guess of other shapes");
  if (!IsFinite(ocp) || IsInfeasible(ocp)) return std::numeric_limits<double>::infinity();
  const bool is_warm = guess != nullptr && IsFinite(*guess);
  if (!is_warm) ColdStart(ocp, &start_);
  problem_.Build(ocp);
  memory_.Take(problem_.view(), &workspace_);
  structured::Settings settings =
      SettingsOf(is_warm, is_warm ? WarmIterations() : options_.max_iterations);
  settings.is_rough = true;
  settings.ceiling = ceiling;
  const structured::Summary summary = Minimize(ocp, is_warm ? *guess : start_, settings);
  return IsDone(summary) && summary.cost <= ceiling ? summary.cost
                                                    : std::numeric_limits<double>::infinity();
}

structured::Settings StructuredSolver::SettingsOf(bool is_warm, int max_iterations) const {
  structured::Settings settings;
  settings.tolerance = options_.tolerance;
  settings.max_iterations = max_iterations;
  settings.is_warm = is_warm;
  return settings;
}

structured::Summary StructuredSolver::Minimize(const CentroidalOcp& ocp, const MpcSolution& start,
                                               const structured::Settings& settings) {
  problem_.Pack(ocp, start, workspace_.point);
  return structured::Minimize(problem_.view(), settings, &workspace_);
}

void StructuredSolver::Optimise(const CentroidalOcp& ocp, const MpcSolution* guess) {
  problem_.Build(ocp);
  memory_.Take(problem_.view(), &workspace_);
  structured::Summary summary;
  if (guess != nullptr) {
    summary = Minimize(ocp, *guess, SettingsOf(true, WarmIterations()));
  }
  // A guess that leads nowhere is worse than none.
  const bool is_done = IsDone(summary) || summary.iterations >= options_.max_iterations;
  if (guess == nullptr || !is_done) {
    const int spent = summary.iterations;
    ColdStart(ocp, &start_);
    summary = Minimize(ocp, start_, SettingsOf(false, options_.max_iterations - spent));
    summary.iterations += spent;
  }
  Report(ocp, summary);
}

void StructuredSolver::Report(const CentroidalOcp& ocp, const structured::Summary& summary) {
  problem_.Unpack(ocp, workspace_.point, &solution_);
  solution_.iterations = summary.iterations;
  solution_.cost = summary.cost;
  solution_.kkt_error = summary.kkt_error;
  solution_.constraint_violation = workspace_.now.largest_residual * ocp.mass_kg;
  if (!IsFinite(solution_)) {  // A recovery that ran away; never handed on.
    ResetToShape(ocp, &solution_);
    solution_.status = SolveStatus::kNumericalError;
    return;
  }
  switch (summary.outcome) {
    case Outcome::kSolved:
      solution_.status = SolveStatus::kSolved;
      break;
    case Outcome::kAcceptable:
      solution_.status = SolveStatus::kAcceptable;
      break;
    case Outcome::kIterationLimit:
      solution_.status = SolveStatus::kIterationLimit;
      break;
    case Outcome::kStuck:
    case Outcome::kTooDear:
      solution_.status = SolveStatus::kNumericalError;
      break;
  }
}

}  // namespace

std::unique_ptr<CentroidalSolver> MakeStructuredSolver(const SolverOptions& options) {
  return std::make_unique<StructuredSolver>(options);
}

}  // namespace sidestep::mpc
