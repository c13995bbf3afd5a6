// SPDX-License-Identifier: BSD-3-Clause
#include "controller/estimator/momentum_observer.h"

#include <algorithm>
#include <cmath>

#include "controller/estimator/low_pass.h"

namespace sidestep {
namespace {

constexpr double kLongestAge_s = 0.1;  // of wrenches that still say something of now

}  // namespace

MomentumObserver::MomentumObserver(const EstimatorParams& params, double mass_kg, double dt_s)
    : params_(params), mass_kg_(mass_kg), dt_s_(dt_s) {
  velocity_mps_.assign(static_cast<std::size_t>(std::ceil(kLongestAge_s / dt_s)) + 2,
                       Eigen::Vector2d::Zero());
}

std::optional<Eigen::Vector2d> MomentumObserver::Update(const Eigen::Vector3d& arms_N, double age_s,
                                                        const RobotState& state) {
  if (params_.push_cutoff_hz == 0.0) return std::nullopt;
  const std::size_t size = velocity_mps_.size();
  velocity_mps_[num_frames_ % size] = state.v_WC.head<2>();
  ++num_frames_;
  const auto age = static_cast<std::size_t>(std::lround(age_s / dt_s_));
  if (age + 2 > std::min(num_frames_, size)) return std::nullopt;
  const std::size_t end = num_frames_ - 1 - age;
  const Eigen::Vector2d change = velocity_mps_[end % size] - velocity_mps_[(end - 1) % size];
  Eigen::Vector2d unexplained_N = mass_kg_ * change / dt_s_ - arms_N.head<2>();
  for (const FootState& foot : state.feet) unexplained_N -= foot.wrench.force_N.head<2>();
  force_N_ += LowPassShare(params_.push_cutoff_hz, dt_s_) * (unexplained_N - force_N_);
  if (force_N_.norm() > params_.push_deadband_N) return force_N_;
  return std::nullopt;
}

}  // namespace sidestep
