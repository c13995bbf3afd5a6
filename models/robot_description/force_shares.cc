// SPDX-License-Identifier: BSD-3-Clause
#include "models/robot_description/force_shares.h"

#include <Eigen/QR>

namespace sidestep {
namespace {

constexpr double kRounding = 1e-12;  // Of shares (up to 1) and lengths (m).

}  // namespace

Eigen::VectorXd ForceShares(const Eigen::Matrix3Xd& vertices_m, const Eigen::Vector2d& cop_m) {
  Eigen::Matrix3Xd A(3, vertices_m.cols());
  A << Eigen::RowVectorXd::Ones(vertices_m.cols()), vertices_m.topRows<2>();
  const Eigen::Vector3d b(1.0, cop_m.x(), cop_m.y());
  // Of least norm also where vertices lie on one line.
  const Eigen::VectorXd shares = A.completeOrthogonalDecomposition().solve(b);
  const bool is_reached = (A * shares - b).cwiseAbs().maxCoeff() < kRounding;
  if (!is_reached || shares.minCoeff() < -kRounding) return {};
  return shares.cwiseMax(0.0);
}

}  // namespace sidestep
