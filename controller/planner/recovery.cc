// SPDX-License-Identifier: BSD-3-Clause
#include "controller/planner/recovery.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "controller/types/gravity.h"

namespace sidestep {
namespace {

constexpr int kDirections = 64;  // of the hull's supporting lines

}  // namespace

double PendulumTimeConstant_s(double height_m) {
  return std::sqrt(std::max(height_m, 0.1) / kGravity_mps2);
}

Eigen::Vector2d CapturePoint(const RobotState& state, double mass_kg) {
  const double time_constant_s = PendulumTimeConstant_s(state.p_WC.z());
  return state.p_WC.head<2>() + time_constant_s * state.v_WC.head<2>() +
         time_constant_s * time_constant_s / mass_kg * state.external_wrench.force_N.head<2>();
}

// A point lies as far outside a convex hull as beyond its farthest supporting line. 64 lines make
// that exact to 0.12 % of the distance from the hull's nearest corner.
double DistanceFromSoles(const Eigen::Vector2d& point, const std::vector<FootState>& feet,
                         const std::vector<Eigen::Matrix3Xd>& vertices_m) {
  double distance_m = 0.0;
  for (int i = 0; i < kDirections; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kDirections;
    const Eigen::Vector2d normal(std::cos(angle), std::sin(angle));
    double support_m = -1e9;
    for (std::size_t foot = 0; foot < feet.size(); ++foot) {
      for (Eigen::Index v = 0; v < vertices_m[foot].cols(); ++v) {
        const Eigen::Vector3d p_WV = feet[foot].p_WF + feet[foot].R_WF * vertices_m[foot].col(v);
        support_m = std::max(support_m, normal.dot(p_WV.head<2>()));
      }
    }
    distance_m = std::max(distance_m, normal.dot(point) - support_m);
  }
  return distance_m;
}

}  // namespace sidestep
