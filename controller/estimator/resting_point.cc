// SPDX-License-Identifier: BSD-3-Clause
#include "controller/estimator/resting_point.h"

#include <algorithm>
#include <cmath>

namespace sidestep {
namespace {

// Soles reach a little beyond the vertices that the MPC uses (iCub3: 5 mm and 13 mm).
constexpr double kBeyondVertices_m = 0.015;
// A vertex so much higher than the lowest counts 1/e of it: what soft ground gives way by.
constexpr double kBlur_m = 0.001;

Eigen::Vector3d LowestVertex(const FootDescription& foot, const Eigen::Matrix3d& R_WF) {
  double lowest_m = (R_WF * foot.vertices_m.col(0)).z();
  for (const auto vertex : foot.vertices_m.colwise()) {
    lowest_m = std::min(lowest_m, R_WF.row(2).dot(vertex));
  }
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double weights = 0.0;
  for (const auto vertex : foot.vertices_m.colwise()) {
    const double weight = std::exp((lowest_m - R_WF.row(2).dot(vertex)) / kBlur_m);
    sum += weight * vertex;
    weights += weight;
  }
  return sum / weights;
}

// In F. m = p x f has no component in the sole but for f's own moment about F.
Eigen::Vector3d CentreOfPressure(const FootDescription& foot, const Wrench& wrench_F) {
  const Eigen::Vector3d& f = wrench_F.force_N;
  const Eigen::Vector3d& m = wrench_F.torque_Nm;
  const double z_m = -foot.sole_height_m;
  const Eigen::Array2d cop_m((z_m * f.x() - m.y()) / f.z(), (m.x() + z_m * f.y()) / f.z());
  const auto vertices_m = foot.vertices_m.topRows<2>();
  const Eigen::Array2d lower_m = vertices_m.rowwise().minCoeff().array() - kBeyondVertices_m;
  const Eigen::Array2d upper_m = vertices_m.rowwise().maxCoeff().array() + kBeyondVertices_m;
  const Eigen::Array2d on_sole_m = cop_m.max(lower_m).min(upper_m);
  return {on_sole_m.x(), on_sole_m.y(), z_m};
}

}  // namespace

Eigen::Vector3d RestingPoint(const FootDescription& foot, const FootState& state) {
  if (foot.vertices_m.cols() == 1) return {0.0, 0.0, -foot.sole_height_m};
  const Eigen::Matrix3d& R_WF = state.R_WF;
  const Wrench wrench_F{R_WF.transpose() * state.wrench.force_N,
                        R_WF.transpose() * state.wrench.torque_Nm};
  const bool feels_moment = !foot.force_torque.empty() && wrench_F.force_N.z() > 0.0;
  return R_WF * (feels_moment ? CentreOfPressure(foot, wrench_F) : LowestVertex(foot, R_WF));
}

}  // namespace sidestep
