// SPDX-License-Identifier: BSD-3-Clause
#include "controller/mpc/ipopt/ipopt_solver.h"

#include <IpIpoptApplication.hpp>
#include <IpSolveStatistics.hpp>
#include <IpTNLP.hpp>
#include <exception>
#include <limits>

#include "controller/mpc/ipopt/centroidal_nlp.h"
#include "controller/mpc/ipopt/nlp_points.h"
#include "controller/mpc/problem/solution_shape.h"
#include "models/support/require.h"

namespace sidestep::mpc {
namespace {

using Ipopt::Index;
using Ipopt::Number;
using ConstMap = Eigen::Map<const Eigen::VectorXd>;
/// Initial barrier parameters: Ipopt's default, and one that suits a shifted solution (tuned on
/// sequences of closed-loop problems).
constexpr double kColdBarrier = 0.1;
constexpr double kWarmBarrier = 1e-4;

using Map = Eigen::Map<Eigen::VectorXd>;

/// CentroidalNlp in Ipopt's calling convention; no mathematics of its own.
class IpoptAdapter final : public Ipopt::TNLP {
 public:
  CentroidalNlp nlp;
  Eigen::VectorXd x;  ///< The starting point, then the final one.

  bool get_nlp_info(Index& n, Index& m, Index& nnz_jac_g, Index& nnz_h_lag,
                    IndexStyleEnum& index_style) override {
    n = nlp.num_variables();
    m = nlp.num_constraints();
    nnz_jac_g = nlp.num_jacobian_entries();
    nnz_h_lag = nlp.num_hessian_entries();
    index_style = TNLP::C_STYLE;
    return true;
  }
  bool get_bounds_info(Index n, Number* x_l, Number* x_u, Index m, Number* g_l,
                       Number* g_u) override {
    nlp.VariableBounds(Map(x_l, n), Map(x_u, n));
    nlp.ConstraintBounds(Map(g_l, m), Map(g_u, m));
    return true;
  }
  bool get_starting_point(Index n, bool init_x, Number* start, bool init_z, Number*, Number*, Index,
                          bool init_lambda, Number*) override {
    if (init_x) {
      Map(start, n) = x;
    }
    return !init_z && !init_lambda;
  }
  bool eval_f(Index n, const Number* at, bool, Number& value) override {
    value = nlp.Cost(ConstMap(at, n));
    return true;
  }
  bool eval_grad_f(Index n, const Number* at, bool, Number* gradient) override {
    nlp.Gradient(ConstMap(at, n), Map(gradient, n));
    return true;
  }
  bool eval_g(Index n, const Number* at, bool, Index m, Number* g) override {
    nlp.Constraints(ConstMap(at, n), Map(g, m));
    return true;
  }
  bool eval_jac_g(Index n, const Number* at, bool, Index, Index, Index* rows, Index* columns,
                  Number* values) override {
    if (values == nullptr) {
      nlp.JacobianStructure(rows, columns);
    } else {
      nlp.JacobianValues(ConstMap(at, n), values);
    }
    return true;
  }
  bool eval_h(Index n, const Number* at, bool, Number cost_factor, Index m,
              const Number* multipliers, bool, Index, Index* rows, Index* columns,
              Number* values) override {
    if (values == nullptr) {
      nlp.HessianStructure(rows, columns);
    } else {
      nlp.HessianValues(ConstMap(at, n), cost_factor, ConstMap(multipliers, m), values);
    }
    return true;
  }
  void finalize_solution(Ipopt::SolverReturn, Index n, const Number* at, const Number*,
                         const Number*, Index, const Number*, const Number*, Number,
                         const Ipopt::IpoptData*, Ipopt::IpoptCalculatedQuantities*) override {
    x = ConstMap(at, n);
  }
};

SolveStatus ToSolveStatus(Ipopt::ApplicationReturnStatus status) {
  switch (status) {
    case Ipopt::Solve_Succeeded:
    case Ipopt::Feasible_Point_Found:  // A square problem: flight over the whole horizon.
      return SolveStatus::kSolved;
    case Ipopt::Solved_To_Acceptable_Level:
      return SolveStatus::kAcceptable;
    case Ipopt::Infeasible_Problem_Detected:
      return SolveStatus::kInfeasible;
    case Ipopt::Maximum_Iterations_Exceeded:
      return SolveStatus::kIterationLimit;
    default:
      return SolveStatus::kNumericalError;
  }
}

class IpoptSolver final : public CentroidalSolver {
 public:
  explicit IpoptSolver(const SolverOptions& options)
      : options_(options), adapter_(new IpoptAdapter), application_(new Ipopt::IpoptApplication) {
    Ipopt::OptionsList& list = *application_->Options();
    list.SetIntegerValue("print_level", 0);
    list.SetStringValue("sb", "yes");
    list.SetStringValue("linear_solver", "mumps");
    list.SetIntegerValue("mumps_pivot_order", 0);
    list.SetNumericValue("tol", options.tolerance);
    list.SetIntegerValue("max_iter", options.max_iterations);
    // No relaxed bounds: the optimum satisfies the friction cones to rounding, as data in SI.
    list.SetNumericValue("bound_relax_factor", 0.0);
    // The NLP is mass-normalised already; scaling by the gradient at the start would make the
    // tolerance depend on the start (and costs warm starts of the hopper twice the iterations).
    list.SetStringValue("nlp_scaling_method", "none");
    // Bound multipliers that match the barrier instead of ones: 14 -> 9 iterations on iCub.
    list.SetStringValue("bound_mult_init_method", "mu-based");
    const Ipopt::ApplicationReturnStatus ready = application_->Initialize("");
    SIDESTEP_REQUIRE(ready == Ipopt::Solve_Succeeded, static_cast<int>(ready));
  }

  const MpcSolution& Solve(const CentroidalOcp& ocp, const MpcSolution* guess) override;
  double Weigh(const CentroidalOcp& ocp, const MpcSolution* guess, double ceiling) override;
  std::unique_ptr<CentroidalSolver> Clone() const override {
    return std::make_unique<IpoptSolver>(options_);
  }

 private:
  void Optimise(const CentroidalOcp& ocp, bool is_warm);

  SolverOptions options_;
  Ipopt::SmartPtr<IpoptAdapter> adapter_;
  Ipopt::SmartPtr<Ipopt::IpoptApplication> application_;
  MpcSolution start_;
  MpcSolution solution_;
};

const MpcSolution& IpoptSolver::Solve(const CentroidalOcp& ocp, const MpcSolution* guess) {
  CheckShapes(ocp);
  SIDESTEP_REQUIRE(guess == nullptr || HasShape(ocp, *guess), "a guess of other shapes");
  ResetToShape(ocp, &solution_);
  solution_.cost = 0.0;
  solution_.constraint_violation = 0.0;
  solution_.kkt_error = 0.0;
  solution_.iterations = 0;
  if (!IsFinite(ocp)) {
    solution_.status = SolveStatus::kNumericalError;
    return solution_;
  }
  if (HasEmptyBox(ocp)) {  // Ipopt would call the problem's definition invalid.
    solution_.status = SolveStatus::kInfeasible;
    return solution_;
  }
  // A guess that has gone astray (a diverged solve) is worse than none.
  const bool is_warm = guess != nullptr && IsFinite(*guess);
  if (!is_warm) {
    ColdStart(ocp, &start_);
  }
  adapter_->nlp.SetProblem(ocp);
  PackPoint(ocp, adapter_->nlp.layout(), is_warm ? *guess : start_, &adapter_->x);
  Optimise(ocp, is_warm);
  return solution_;
}

double IpoptSolver::Weigh(const CentroidalOcp& ocp, const MpcSolution* guess, double ceiling) {
  const MpcSolution& solution = Solve(ocp, guess);
  return IsUsable(solution.status) && solution.cost <= ceiling
             ? solution.cost
             : std::numeric_limits<double>::infinity();
}

void IpoptSolver::Optimise(const CentroidalOcp& ocp, bool is_warm) {
  Ipopt::OptionsList& list = *application_->Options();
  // Measured: adaptive halves the iterations of cold starts far from the optimum (pushed biped: 47
  // against 83); near it, a fixed small barrier keeps the guess and costs less an iteration.
  list.SetStringValue("mu_strategy", is_warm ? "monotone" : "adaptive");
  list.SetNumericValue("mu_init", is_warm ? kWarmBarrier : kColdBarrier);
  Ipopt::ApplicationReturnStatus result = Ipopt::Internal_Error;
  try {
    result = application_->OptimizeTNLP(Ipopt::GetRawPtr(adapter_));
  } catch (const std::exception&) {
    result = Ipopt::NonIpopt_Exception_Thrown;  // bad_alloc within Ipopt or MUMPS, say.
  }
  solution_.status = ToSolveStatus(result);
  const CentroidalNlp& nlp = adapter_->nlp;
  if (adapter_->x.allFinite()) {
    UnpackPoint(ocp, nlp.layout(), adapter_->x, &solution_);
    solution_.cost = nlp.Cost(adapter_->x);
    solution_.constraint_violation = nlp.ConstraintViolation(adapter_->x);
  }
  const Ipopt::SmartPtr<Ipopt::SolveStatistics> statistics = application_->Statistics();
  if (Ipopt::IsValid(statistics)) {
    solution_.iterations = statistics->IterationCount();
    Number dual = 0.0, constraint = 0.0, complementarity = 0.0;
    statistics->ScaledInfeasibilities(dual, constraint, complementarity, solution_.kkt_error);
  }
}

}  // namespace

std::unique_ptr<CentroidalSolver> MakeIpoptSolver(const SolverOptions& options) {
  return std::make_unique<IpoptSolver>(options);
}

}  // namespace sidestep::mpc
