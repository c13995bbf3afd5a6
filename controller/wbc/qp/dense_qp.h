// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// dense_qp: a small dense convex quadratic program, solved every control tick.
//
//   minimise  1/2 x' H x + g' x    subject to    A x = b,    lower <= C x <= upper
//
// Flow: [wbc: stack of tasks -> QP -> joint commands]. No unit is assumed: variables may mix
// forces (1e3 N) and accelerations (10 m/s^2); the solver scales them by the diagonal of H.
//
// Method: a dual active-set method (Goldfarb & Idnani, "A numerically stable dual method for
// solving strictly convex quadratic programs", Math. Programming 27, 1983), in the null space of
// the equalities, inside proximal-point passes. Why not an interior point:
// - a whole-body QP has few degrees of freedom left once the dynamics hold (about 20 of 60) and
//   few active limits, so an active-set change costs microseconds where a barrier step, over all
//   inequalities, costs ten times as much; the last active set warm-starts the next tick;
// - sets without interior (a swing foot with 0 <= f_z <= 0 and a friction cone) and redundant
//   rows are ordinary here, and exact; infeasibility ends with a certificate;
// - a pivoted QR of the equalities settles dependent rows (two feet on the ground) once, ahead.
// H only has to be semi-definite: where its null-space part is flat, rho/2 |x - x_k|^2 is added
// and x_k moved until the unregularised optimality conditions hold; every pass recomputes the
// residuals from the caller's data, so passes also act as iterative refinement.

#include <Eigen/Core>
#include <limits>
#include <memory>

#include "controller/types/solver_status.h"

namespace sidestep::wbc {

namespace internal {
class QpWorkspace;
}

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();  ///< No bound.

/// Sizes of a problem, or the largest sizes a solver has room for.
struct DenseQpDimensions {
  int variables{0};     ///< n
  int equalities{0};    ///< m_e, may be 0
  int inequalities{0};  ///< m_i, may be 0
};

/// A problem that owns its data.
struct DenseQpProblem {
  Eigen::MatrixXd H;      ///< n x n, symmetric (both triangles are read), positive semi-definite.
  Eigen::VectorXd g;      ///< n
  Eigen::MatrixXd A;      ///< m_e x n, of any rank.
  Eigen::VectorXd b;      ///< m_e
  Eigen::MatrixXd C;      ///< m_i x n; dependent, duplicate and zero rows are allowed.
  Eigen::VectorXd lower;  ///< m_i; -kInfinity for none.
  Eigen::VectorXd upper;  ///< m_i; kInfinity for none. upper == lower makes an equality.
};

/// A problem that looks at someone else's data, shapes as in DenseQpProblem. A caller whose sizes
/// change from tick to tick keeps matrices of the largest size and passes blocks of them:
/// `solver.Solve({H, g, A.topRows(m), b.head(m), C.topRows(k), lower.head(k), upper.head(k)})`
/// allocates nothing. Columns must be contiguous, or Eigen copies (and allocates).
struct DenseQpView {
  using ConstMatrix = Eigen::Ref<const Eigen::MatrixXd>;
  using ConstVector = Eigen::Ref<const Eigen::VectorXd>;

  DenseQpView(const ConstMatrix& H_, const ConstVector& g_, const ConstMatrix& A_,
              const ConstVector& b_, const ConstMatrix& C_, const ConstVector& lower_,
              const ConstVector& upper_)
      : H(H_), g(g_), A(A_), b(b_), C(C_), lower(lower_), upper(upper_) {}

  /// Implicit on purpose: an owned problem is passed as it is. Valid while `problem` lives.
  DenseQpView(const DenseQpProblem& problem)  // NOLINT(google-explicit-constructor)
      : DenseQpView(problem.H, problem.g, problem.A, problem.b, problem.C, problem.lower,
                    problem.upper) {}

  ConstMatrix H;
  ConstVector g;
  ConstMatrix A;
  ConstVector b;
  ConstMatrix C;
  ConstVector lower;
  ConstVector upper;
};

/// When to stop. Iterations and residuals only, never time.
struct DenseQpOptions {
  double tolerance{1e-9};   ///< On the relative residuals of DenseQpSolution.
  int max_iterations{500};  ///< Active-set changes, over all passes.
  int max_passes{20};       ///< Proximal and refinement passes; one or two are usual.
};

/// Largest n, m_e or m_i of any solver: bounds the storage of QpVector.
constexpr int kMaxQpDimension = 512;

/// A vector whose size varies without touching the heap; otherwise an Eigen::VectorXd.
using QpVector = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, kMaxQpDimension, 1>;

/// Answer, with multipliers of the Lagrangian
///   1/2 x'Hx + g'x + nu'(Ax - b) + lambda'(Cx - bound),   H x + g + A' nu + C' lambda = 0.
/// Where rows are dependent the multipliers are not unique; one valid choice is returned.
struct DenseQpSolution {
  QpStatus status{QpStatus::kNotSolved};
  QpVector x;                       ///< n; all zero unless the status is kSolved or the limit.
  QpVector equality_multipliers;    ///< nu, m_e.
  QpVector inequality_multipliers;  ///< lambda, m_i: > 0 at upper, < 0 at lower, 0 if inactive.
  /// Largest violation of A x = b or of a bound, each row divided by 1 + |b_i| or 1 + |bound_i|.
  double primal_residual{0.0};
  /// Largest entry of H x + g + A' nu + C' lambda, each divided by 1 + its largest term.
  double dual_residual{0.0};
  /// Largest |lambda_i| * distance to its bound, divided by 1 + |x'Hx| + |g'x|.
  double complementarity{0.0};
  int iterations{0};  ///< Active-set changes.
  int passes{0};      ///< Proximal and refinement passes.
};

/// Solver with all its memory taken at construction. Not thread-safe; deterministic.
class DenseQpSolver {
 public:
  /// Takes memory for problems up to `maxima`.
  /// @throws ContractViolation if an entry is negative, above kMaxQpDimension, or variables is 0.
  explicit DenseQpSolver(const DenseQpDimensions& maxima, const DenseQpOptions& options = {});
  ~DenseQpSolver();
  /// A copy solves on bit for bit as the original does. Copying takes memory.
  DenseQpSolver(const DenseQpSolver& other);
  DenseQpSolver& operator=(const DenseQpSolver& other);
  DenseQpSolver(DenseQpSolver&&) noexcept;
  DenseQpSolver& operator=(DenseQpSolver&&) noexcept;

  /// Solves a problem no larger than the maxima. Hard problems are a status, never an exception.
  ///
  /// @param problem  shapes as in DenseQpProblem; C and A may have no rows (but n columns).
  /// @param guess    may be null. An earlier answer, possibly the last one returned by this very
  ///                 solver: the signs of its inequality multipliers name the active set to start
  ///                 from. Ignored when m_i differs. It changes the path, not the optimum.
  /// @return         the solver's own record, valid until the next call.
  /// @throws ContractViolation if shapes disagree with each other or exceed the maxima.
  /// Does not allocate.
  const DenseQpSolution& Solve(const DenseQpView& problem, const DenseQpSolution* guess = nullptr);

 private:
  std::unique_ptr<internal::QpWorkspace> workspace_;
};

}  // namespace sidestep::wbc
