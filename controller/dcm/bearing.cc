// SPDX-License-Identifier: BSD-3-Clause
#include "controller/dcm/bearing.h"

#include <algorithm>

#include "controller/planner/capture_point.h"
#include "models/support/gravity.h"
#include "models/support/require.h"

namespace sidestep::dcm {

Bearing::Bearing(const DcmSetup& setup)
    : setup_(setup), omega_per_s_(1.0 / PendulumTimeConstant_s(setup.com_height_m)) {
  SIDESTEP_REQUIRE(setup.vertices_m.size() == 2, setup.vertices_m.size());
  Eigen::Index vertices = 0;
  for (const Eigen::Matrix3Xd& sole : setup.vertices_m) {
    force_N_.emplace_back(Eigen::Matrix3Xd::Zero(3, sole.cols()));
    vertices += sole.cols();
  }
  SIDESTEP_REQUIRE(vertices <= static_cast<Eigen::Index>(SupportArea::kMost), vertices);
}

void Bearing::Update(const RobotState& state, const Eigen::Vector2d& dcm_m,
                     const DcmReference& reference, const GaitPlanner& planner, Tick now) {
  for (std::size_t foot = 0; foot < 2; ++foot) {
    stands_[foot] = planner.plan().feet[foot].front().start_tick <= now;
  }
  const Eigen::Vector2d pressure_m = Pressure(state, dcm_m, reference);
  const Eigen::Vector2d borne_mps2 =
      omega_per_s_ * omega_per_s_ * (state.p_WC.head<2>() - pressure_m);
  com_.p_WC << state.p_WC.head<2>(), planner.ReferenceAt(now).p_WC.z();
  com_.v_WC << state.v_WC.head<2>(), 0.0;
  com_.a_WC << borne_mps2 + state.external_wrench.force_N.head<2>() / setup_.mass_kg, 0.0;
  ShareOut(state, pressure_m);
}

Eigen::Vector2d Bearing::Pressure(const RobotState& state, const Eigen::Vector2d& dcm_m,
                                  const DcmReference& reference) const {
  SupportArea area;
  for (std::size_t foot = 0; foot < 2; ++foot) {
    if (!stands_[foot]) continue;
    AddInnerSole(state.feet[foot], setup_.vertices_m[foot], setup_.control.dcm.sole_share, &area);
  }
  const Eigen::Vector2d error_m = dcm_m - reference.DcmAt(0.0);
  const Eigen::Vector2d pressure_m =
      reference.pressure_m() + (1.0 + setup_.control.dcm.gain_per_s / omega_per_s_) * error_m;
  return area.is_empty() ? pressure_m : area.Nearest(pressure_m);
}

// By where the pressure is on the way from the left foot to the right one.
double Bearing::ShareOfRight(const RobotState& state, const Eigen::Vector2d& pressure_m) const {
  if (!stands_[0] || !stands_[1]) return stands_[1] ? 1.0 : 0.0;
  constexpr double kTogether_m2 = 1e-6;  // feet in one place share alike
  const Eigen::Vector2d left_m = state.feet[0].p_WF.head<2>();
  const Eigen::Vector2d across_m = state.feet[1].p_WF.head<2>() - left_m;
  if (across_m.squaredNorm() <= kTogether_m2) return 0.5;
  return std::clamp(across_m.dot(pressure_m - left_m) / across_m.squaredNorm(), 0.0, 1.0);
}

void Bearing::ShareOut(const RobotState& state, const Eigen::Vector2d& pressure_m) {
  const double on_right = ShareOfRight(state, pressure_m);
  SupportArea soles;
  for (std::size_t foot = 0; foot < 2; ++foot) {
    if (!stands_[foot]) continue;
    const double liked = (foot == 0 ? 1.0 - on_right : on_right) /
                         static_cast<double>(setup_.vertices_m[foot].cols());
    for (const auto& vertex_m : setup_.vertices_m[foot].colwise()) {
      soles.Add((state.feet[foot].p_WF + state.feet[foot].R_WF * vertex_m).head<2>(), liked);
    }
  }
  if (!soles.is_empty()) soles.ShareOut(pressure_m);
  const Eigen::Vector3d force_N =
      setup_.mass_kg * (com_.a_WC + Eigen::Vector3d(0.0, 0.0, kGravity_mps2)) -
      state.external_wrench.force_N;
  std::size_t vertex = 0;
  for (std::size_t foot = 0; foot < 2; ++foot) {
    force_N_[foot].setZero();
    if (!stands_[foot]) continue;
    for (auto on_vertex_N : force_N_[foot].colwise()) on_vertex_N = soles.share(vertex++) * force_N;
  }
}

}  // namespace sidestep::dcm
