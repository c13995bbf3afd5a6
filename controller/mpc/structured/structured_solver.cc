// SPDX-License-Identifier: BSD-3-Clause
#include "controller/mpc/structured/structured_solver.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "controller/mpc/problem/feasibility.h"
#include "controller/mpc/problem/solution_shape.h"
#include "controller/mpc/structured/interior_point.h"
#include "controller/mpc/structured/minimize.h"
#include "controller/mpc/structured/structured_memory.h"
#include "controller/mpc/structured/structured_problem.h"
#include "models/support/require.h"

namespace sidestep::mpc {
namespace {

using structured::Outcome;
using structured::ProblemView;

constexpr int kMaxWarmIterations = 50;      // Then a cold start; good guesses take up to 15.
constexpr int kMaxPatientIterations = 450;  // Half of a generous limit.
constexpr double kLargestSlope = 100.0;     // Of a patient solve's cost, as Ipopt scales it.

class StructuredSolver final : public CentroidalSolver {
 public:
  explicit StructuredSolver(const SolverOptions& options) : options_(options) {}

  const MpcSolution& Solve(const CentroidalOcp& ocp, const MpcSolution* guess) override;
  double Weigh(const CentroidalOcp& ocp, const MpcSolution* guess, double ceiling) override;
  std::unique_ptr<CentroidalSolver> Clone() const override {
    return std::make_unique<StructuredSolver>(options_);
  }

 private:
  structured::Settings SettingsOf(int max_iterations) const;
  structured::Summary Minimize(const CentroidalOcp& ocp, const MpcSolution& start,
                               const structured::Settings& settings);
  void Optimise(const CentroidalOcp& ocp, const MpcSolution* guess);
  /// Whether a solve is neither done nor out of iterations.
  bool IsOpen(const structured::Summary& summary) const;
  /// Starts again, cold, with the iterations that are left.
  void Resume(const CentroidalOcp& ocp, structured::Settings settings,
              structured::Summary* summary);
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
      SettingsOf(is_warm ? kMaxWarmIterations : options_.max_iterations);
  settings.is_warm = is_warm;
  settings.is_rough = true;
  settings.ceiling = ceiling;
  const structured::Summary summary = Minimize(ocp, is_warm ? *guess : start_, settings);
  return IsDone(summary) && summary.cost <= ceiling ? summary.cost
                                                    : std::numeric_limits<double>::infinity();
}

structured::Settings StructuredSolver::SettingsOf(int max_iterations) const {
  structured::Settings settings;
  settings.tolerance = options_.tolerance;
  settings.max_iterations = std::min(options_.max_iterations, max_iterations);
  return settings;
}

structured::Summary StructuredSolver::Minimize(const CentroidalOcp& ocp, const MpcSolution& start,
                                               const structured::Settings& settings) {
  problem_.Pack(ocp, start, workspace_.point);
  return structured::Minimize(problem_.view(), settings, &workspace_);
}

// A guess that leads nowhere is worse than none. From a cold start, where the cost hardly cares (no
// weight on the CoM or the momentum), the barrier alone decides, and the fast way overshoots: it
// stops there for the patient one, and comes back if that fails too.
void StructuredSolver::Optimise(const CentroidalOcp& ocp, const MpcSolution* guess) {
  problem_.Build(ocp);
  memory_.Take(problem_.view(), &workspace_);
  structured::Summary summary;
  if (guess != nullptr) {
    structured::Settings warm = SettingsOf(kMaxWarmIterations);
    warm.is_warm = true;
    summary = Minimize(ocp, *guess, warm);
  }
  if (guess == nullptr || IsOpen(summary)) {
    ColdStart(ocp, &start_);
    structured::Settings wary = SettingsOf(options_.max_iterations);
    wary.is_wary = true;
    Resume(ocp, wary, &summary);
  }
  if (IsOpen(summary)) {
    structured::Settings patient = SettingsOf(kMaxPatientIterations);
    patient.is_patient = true;
    const double scale = kLargestSlope / std::max(kLargestSlope, summary.first_slope);
    problem_.ScaleCost(scale);
    Resume(ocp, patient, &summary);
    summary.cost /= scale;
  }
  if (IsOpen(summary)) {
    problem_.Build(ocp);  // with its own cost again
    Resume(ocp, SettingsOf(options_.max_iterations), &summary);
  }
  Report(ocp, summary);
}

bool StructuredSolver::IsOpen(const structured::Summary& summary) const {
  return !IsDone(summary) && summary.iterations < options_.max_iterations;
}

void StructuredSolver::Resume(const CentroidalOcp& ocp, structured::Settings settings,
                              structured::Summary* summary) {
  const int spent = summary->iterations;
  settings.max_iterations = std::min(settings.max_iterations, options_.max_iterations - spent);
  *summary = Minimize(ocp, start_, settings);
  summary->iterations += spent;
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
