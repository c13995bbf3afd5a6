// SPDX-License-Identifier: BSD-3-Clause
#include "controller/mpc/structured/structured_solver.h"

#include <algorithm>
#include <utility>

#include "controller/mpc/nlp_points.h"
#include "controller/mpc/structured/arena.h"
#include "controller/mpc/structured/force_limits.h"
#include "controller/mpc/structured/interior_point.h"
#include "controller/mpc/structured/minimize.h"
#include "controller/mpc/structured/structured_problem.h"
#include "models/support/require.h"

namespace sidestep::mpc {
namespace {

using structured::Outcome;
using structured::ProblemView;

class StructuredSolver final : public CentroidalSolver {
 public:
  explicit StructuredSolver(const SolverOptions& options) : options_(options) {}

  const MpcSolution& Solve(const CentroidalOcp& ocp, const MpcSolution* guess) override;

 private:
  void TakeMemory();
  void Optimise(const CentroidalOcp& ocp, bool is_warm);
  void Report(const CentroidalOcp& ocp, const structured::Summary& summary);

  SolverOptions options_;
  structured::StructuredProblem problem_;
  structured::Arena arena_;
  structured::Workspace workspace_;
  MpcSolution start_;
  MpcSolution solution_;
};

constexpr double kForceTolerance = 1e-9;  // Relative: below what the optimum is compared at.

std::size_t Size(int count) { return static_cast<std::size_t>(count); }

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

void StructuredSolver::TakeMemory() {
  const ProblemView& view = problem_.view();
  const std::size_t point = Size(view.at.size);
  const std::size_t slots = Size(view.num_slots);
  const std::size_t residuals = Size(view.num_faces) * slots;
  const std::size_t stages = Size(view.knots + 1);
  std::size_t tail = 0, active = 0, rows = 0, blocks = 0;
  for (std::size_t k = 0; k < stages; ++k) {
    const structured::Stage& stage = view.stages[k];
    const std::size_t kept = Size(stage.num_rows - stage.num_pivots);
    tail = std::max(tail, kept * kept);
    active = std::max(active, Size(stage.num_active));
    rows = std::max(rows, Size(stage.num_rows));
    blocks += Size(stage.num_blocks);
  }
  arena_.Reset(7 * point + 2 * residuals + 33 * stages + 9 * slots + 3 * blocks +
                   3 * Size(view.num_locations) + 2 * tail + 24 * active + 2 * rows +
                   Size(view.num_pivots),
               32);
  for (double** array :
       {&workspace_.point, &workspace_.trial, &workspace_.direction, &workspace_.target,
        &workspace_.change, &workspace_.linear.gradient, &workspace_.newton.slope}) {
    *array = arena_.Take(point);
  }
  for (structured::Evaluation* evaluation : {&workspace_.now, &workspace_.next}) {
    evaluation->gap = arena_.Take(9 * stages);
    evaluation->residual = arena_.Take(residuals);
  }
  workspace_.linear.arm = arena_.Take(3 * slots);
  workspace_.linear.force = arena_.Take(3 * stages);
  workspace_.linear.block_force = arena_.Take(3 * blocks);
  workspace_.linear.costate = arena_.Take(9 * stages);
  workspace_.newton.curvature = arena_.Take(6 * slots);
  workspace_.newton.box_curvature = arena_.Take(3 * Size(view.num_locations));
  workspace_.newton.tail[0] = arena_.Take(tail);
  workspace_.newton.tail[1] = arena_.Take(tail);
  workspace_.newton.value = arena_.Take(12 * active);
  workspace_.newton.product = arena_.Take(12 * active);
  workspace_.newton.vector = arena_.Take(rows);
  workspace_.newton.kept = arena_.Take(rows);
  workspace_.newton.change = arena_.Take(Size(view.num_pivots));
}

const MpcSolution& StructuredSolver::Solve(const CentroidalOcp& ocp, const MpcSolution* guess) {
  CheckShapes(ocp);
  SIDESTEP_REQUIRE(guess == nullptr || HasShape(ocp, *guess), "a guess of other shapes");
  const bool is_finite = IsFinite(ocp);
  const bool is_warm = is_finite && guess != nullptr && IsFinite(*guess);
  const bool is_infeasible = is_finite && IsInfeasible(ocp);
  if (is_finite && !is_infeasible) {
    problem_.Build(ocp);
    TakeMemory();
    if (!is_warm) ColdStart(ocp, &start_);
    problem_.Pack(ocp, is_warm ? *guess : start_, workspace_.point);
  }
  ResetToShape(ocp, &solution_);
  solution_.cost = 0.0;
  solution_.constraint_violation = 0.0;
  solution_.kkt_error = 0.0;
  solution_.iterations = 0;
  solution_.status = is_infeasible ? SolveStatus::kInfeasible : SolveStatus::kNumericalError;
  if (is_finite && !is_infeasible) Optimise(ocp, is_warm);
  return solution_;
}

void StructuredSolver::Optimise(const CentroidalOcp& ocp, bool is_warm) {
  structured::Settings settings;
  settings.tolerance = options_.tolerance;
  settings.max_iterations = options_.max_iterations;
  settings.barrier = is_warm ? 1e-3 : 1e-1;
  settings.push = 1e-2;
  Report(ocp, structured::Minimize(problem_.view(), settings, &workspace_));
}

void StructuredSolver::Report(const CentroidalOcp& ocp, const structured::Summary& summary) {
  problem_.Unpack(ocp, workspace_.point, &solution_);
  solution_.iterations = summary.iterations;
  solution_.cost = summary.cost;
  solution_.kkt_error = summary.kkt_error;
  solution_.constraint_violation = workspace_.now.largest_residual * ocp.mass_kg;
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
      solution_.status = SolveStatus::kNumericalError;
      break;
  }
}

}  // namespace

std::unique_ptr<CentroidalSolver> MakeStructuredSolver(const SolverOptions& options) {
  return std::make_unique<StructuredSolver>(options);
}

}  // namespace sidestep::mpc
