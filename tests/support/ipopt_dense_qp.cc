// SPDX-License-Identifier: BSD-3-Clause
#include "tests/support/ipopt_dense_qp.h"

#include <Eigen/QR>
#include <IpIpoptApplication.hpp>
#include <IpTNLP.hpp>
#include <algorithm>

namespace sidestep::wbc {

namespace {

constexpr double kIpoptInfinity = 1e20;  // beyond its nlp_upper_bound_inf

class QpAsNlp : public Ipopt::TNLP {
 public:
  QpAsNlp(const DenseQpProblem& problem, IpoptQpResult& result)
      : problem_(problem), result_(result) {
    rows_.resize(problem.A.rows() + problem.C.rows(), problem.g.size());
    rows_ << problem.A, problem.C;
  }

  bool get_nlp_info(int& n, int& m, int& nnz_jac, int& nnz_hess, IndexStyleEnum& style) override {
    n = static_cast<int>(problem_.g.size());
    m = static_cast<int>(rows_.rows());
    nnz_jac = n * m;
    nnz_hess = n * (n + 1) / 2;
    style = C_STYLE;
    return true;
  }

  bool get_bounds_info(int n, double* x_l, double* x_u, int, double* g_l, double* g_u) override {
    std::fill(x_l, x_l + n, -kIpoptInfinity);
    std::fill(x_u, x_u + n, kIpoptInfinity);
    const Eigen::Index equalities = problem_.b.size();
    for (Eigen::Index i = 0; i < rows_.rows(); ++i) {
      const bool is_equality = i < equalities;
      g_l[i] = is_equality ? problem_.b(i) : problem_.lower(i - equalities);
      g_u[i] = is_equality ? problem_.b(i) : problem_.upper(i - equalities);
      g_l[i] = std::max(g_l[i], -kIpoptInfinity);
      g_u[i] = std::min(g_u[i], kIpoptInfinity);
    }
    return true;
  }

  bool get_starting_point(int n, bool, double* x, bool, double*, double*, int, bool,
                          double*) override {
    std::fill(x, x + n, 0.0);
    return true;
  }

  bool eval_f(int n, const double* x, bool, double& value) override {
    const Eigen::Map<const Eigen::VectorXd> point(x, n);
    value = 0.5 * point.dot(problem_.H * point) + problem_.g.dot(point);
    return true;
  }

  bool eval_grad_f(int n, const double* x, bool, double* gradient) override {
    const Eigen::Map<const Eigen::VectorXd> point(x, n);
    Eigen::Map<Eigen::VectorXd>(gradient, n) = problem_.H * point + problem_.g;
    return true;
  }

  bool eval_g(int n, const double* x, bool, int m, double* values) override {
    Eigen::Map<Eigen::VectorXd>(values, m) = rows_ * Eigen::Map<const Eigen::VectorXd>(x, n);
    return true;
  }

  bool eval_jac_g(int n, const double*, bool, int m, int, int* row, int* col,
                  double* values) override {
    for (int i = 0, k = 0; i < m; ++i) {
      for (int j = 0; j < n; ++j, ++k) {
        if (values == nullptr) {
          row[k] = i;
          col[k] = j;
        } else {
          values[k] = rows_(i, j);
        }
      }
    }
    return true;
  }

  bool eval_h(int n, const double*, bool, double weight, int, const double*, bool, int, int* row,
              int* col, double* values) override {
    for (int i = 0, k = 0; i < n; ++i) {
      for (int j = 0; j <= i; ++j, ++k) {
        if (values == nullptr) {
          row[k] = i;
          col[k] = j;
        } else {
          values[k] = weight * problem_.H(i, j);
        }
      }
    }
    return true;
  }

  void finalize_solution(Ipopt::SolverReturn, int n, const double* x, const double*, const double*,
                         int, const double*, const double*, double, const Ipopt::IpoptData*,
                         Ipopt::IpoptCalculatedQuantities*) override {
    result_.x = Eigen::Map<const Eigen::VectorXd>(x, n);
  }

 private:
  const DenseQpProblem& problem_;
  IpoptQpResult& result_;
  Eigen::MatrixXd rows_;
};

// With dependent equalities Ipopt's multipliers grow without bound and it stops far from optimal
// (measured: cost off by 10 %). The feasible set is the same without them.
DenseQpProblem WithoutDependentEqualities(const DenseQpProblem& problem) {
  if (problem.A.rows() == 0) {
    return problem;
  }
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(problem.A.transpose());
  qr.setThreshold(1e-9);
  const Eigen::VectorXi pivots = qr.colsPermutation().indices();
  DenseQpProblem reduced = problem;
  reduced.A.resize(qr.rank(), problem.A.cols());
  reduced.b.resize(qr.rank());
  for (Eigen::Index k = 0; k < qr.rank(); ++k) {
    reduced.A.row(k) = problem.A.row(pivots(k));
    reduced.b(k) = problem.b(pivots(k));
  }
  return reduced;
}

}  // namespace

IpoptQpResult SolveWithIpopt(const DenseQpProblem& whole, double tolerance) {
  const DenseQpProblem problem = WithoutDependentEqualities(whole);
  IpoptQpResult result;
  const Ipopt::SmartPtr<Ipopt::IpoptApplication> app = IpoptApplicationFactory();
  app->Options()->SetIntegerValue("print_level", 0);
  app->Options()->SetStringValue("sb", "yes");
  app->Options()->SetNumericValue("tol", tolerance);
  app->Options()->SetNumericValue("constr_viol_tol", tolerance);
  app->Options()->SetNumericValue("compl_inf_tol", tolerance);
  app->Options()->SetNumericValue("dual_inf_tol", 1e-6);
  // Large multipliers must not loosen the tolerances, as they do by default.
  app->Options()->SetNumericValue("s_max", 1e8);
  app->Options()->SetNumericValue("bound_relax_factor", 0.0);
  app->Options()->SetIntegerValue("acceptable_iter", 0);
  app->Options()->SetIntegerValue("max_iter", 500);
  app->Options()->SetStringValue("hessian_constant", "yes");
  app->Options()->SetStringValue("jac_c_constant", "yes");
  app->Options()->SetStringValue("jac_d_constant", "yes");
  app->Options()->SetStringValue("mu_strategy", "adaptive");
  if (app->Initialize("") != Ipopt::Solve_Succeeded) {
    return result;
  }
  const Ipopt::SmartPtr<Ipopt::TNLP> nlp = new QpAsNlp(problem, result);
  const Ipopt::ApplicationReturnStatus status = app->OptimizeTNLP(nlp);
  result.is_solved = status == Ipopt::Solve_Succeeded;
  result.is_infeasible = status == Ipopt::Infeasible_Problem_Detected;
  if (!result.is_solved) {
    result.x.resize(0);
  }
  return result;
}

}  // namespace sidestep::wbc
