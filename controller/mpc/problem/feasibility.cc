// SPDX-License-Identifier: BSD-3-Clause
#include "controller/mpc/problem/feasibility.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <sstream>

namespace sidestep::mpc {
namespace {

constexpr int kMaxSteps = 100;            // A handful of rows needs fewer than ten.
constexpr double kForceTolerance = 1e-9;  // Relative: below what the optimum is compared at.

/// Half the squared violation at f with rows scaled to unit length, and its derivatives.
struct Violation {
  double value{0.0};
  double largest{0.0};
  Eigen::Vector3d slope{Eigen::Vector3d::Zero()};
  Eigen::Matrix3d curvature{Eigen::Matrix3d::Zero()};
};

Violation ViolationAt(const Eigen::MatrixX3d& A, const Eigen::VectorXd& b,
                      const Eigen::Vector3d& f) {
  Violation at;
  for (Eigen::Index r = 0; r < A.rows(); ++r) {
    const double length = std::max(A.row(r).norm(), 1e-12);
    const Eigen::Vector3d row = A.row(r).transpose() / length;
    const double excess = row.dot(f) - b(r) / length;
    at.largest = std::max(at.largest, excess);
    if (excess <= 0.0) continue;
    at.value += 0.5 * excess * excess;
    at.slope += excess * row;
    at.curvature += row * row.transpose();
  }
  return at;
}

bool HasActiveContact(const CentroidalOcp& ocp) {
  return std::any_of(ocp.contacts.begin(), ocp.contacts.end(), [&](const OcpContact& contact) {
    return std::any_of(contact.phases.begin(), contact.phases.end(),
                       [&](const ContactPhase& phase) {
                         return phase.first_knot < ocp.knots && phase.end_knot > 0;
                       });
  });
}

}  // namespace

double LeastForceViolation(const Eigen::MatrixX3d& A, const Eigen::VectorXd& b, double enough) {
  Eigen::Vector3d f = Eigen::Vector3d::Zero();
  Violation at = ViolationAt(A, b, f);
  for (int step = 0; step < kMaxSteps && at.largest > enough; ++step) {
    at.curvature.diagonal().array() += 1e-10;
    const Eigen::Vector3d move = -at.curvature.ldlt().solve(at.slope);
    double length = 1.0;
    Violation next = ViolationAt(A, b, f + move);
    while (next.value > at.value + 1e-4 * length * at.slope.dot(move) && length > 1e-10) {
      length *= 0.5;
      next = ViolationAt(A, b, f + length * move);
    }
    if (!(next.value < at.value)) break;
    f += length * move;
    at = next;
  }
  return at.largest;
}

bool HasFeasibleForce(const Eigen::MatrixX3d& A, const Eigen::VectorXd& b, double tolerance) {
  const double small = tolerance * std::max(1.0, b.size() == 0 ? 0.0 : b.cwiseAbs().maxCoeff());
  return LeastForceViolation(A, b, small) <= small;
}

bool IsInfeasible(const CentroidalOcp& ocp) {
  return HasEmptyBox(ocp) || (HasActiveContact(ocp) &&
                              !HasFeasibleForce(ocp.friction_A, ocp.friction_b, kForceTolerance));
}

std::string Infeasibility(const CentroidalOcp& ocp) {
  if (!IsInfeasible(ocp)) return {};
  if (HasEmptyBox(ocp)) return "a foot's box has its lower bound above its upper one";
  std::ostringstream text;
  text.precision(2);
  text << "no force keeps the friction rows: the best misses one by "
       << LeastForceViolation(ocp.friction_A, ocp.friction_b, 0.0) << " N";
  return text.str();
}

}  // namespace sidestep::mpc
