// SPDX-License-Identifier: BSD-3-Clause
#include "controller/estimator/momentum_observer.h"

#include <algorithm>
#include <cmath>

#include "controller/estimator/low_pass.h"
#include "models/support/gravity.h"

namespace sidestep {
namespace {

constexpr double kLongestAge_s = 0.1;  // of wrenches that still say something of now
constexpr double kQuicker = 3.0;       // cutoff of the low-pass that tells of a push's end
constexpr double kGone = 0.25;  // of the push: what the quicker one has left of one that is over

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
  if (Settles(state)) {
    const double left = std::exp(-dt_s_ / params_.push_decay_s);
    force_N_ *= left;
    quick_N_ *= left;
  } else {
    Learn(Unexplained_N(arms_N, age, state));
  }
  if (force_N_.norm() > params_.push_deadband_N) return force_N_;
  return std::nullopt;
}

Eigen::Vector2d MomentumObserver::Unexplained_N(const Eigen::Vector3d& arms_N, std::size_t age,
                                                const RobotState& state) const {
  const std::size_t size = velocity_mps_.size();
  const std::size_t end = num_frames_ - 1 - age;
  const Eigen::Vector2d change = velocity_mps_[end % size] - velocity_mps_[(end - 1) % size];
  Eigen::Vector2d unexplained_N = mass_kg_ * change / dt_s_ - arms_N.head<2>();
  for (const FootState& foot : state.feet) unexplained_N -= foot.wrench.force_N.head<2>();
  const double limit_N = params_.push_limit_ratio * mass_kg_ * kGravity_mps2;
  const double norm_N = unexplained_N.norm();
  if (norm_N > limit_N) unexplained_N *= limit_N / norm_N;
  return unexplained_N;
}

// A robot stands when it is first seen: that is no landing.
bool MomentumObserver::Settles(const RobotState& state) {
  settle_s_ = std::max(0.0, settle_s_ - dt_s_);
  in_contact_.resize(state.feet.size(), true);
  for (std::size_t i = 0; i < state.feet.size(); ++i) {
    const bool touches = state.feet[i].in_contact;
    if (touches && !in_contact_[i]) settle_s_ = params_.push_settle_s;
    in_contact_[i] = touches;
  }
  return settle_s_ > 0.0;
}

void MomentumObserver::Learn(const Eigen::Vector2d& unexplained_N) {
  const double share = LowPassShare(params_.push_cutoff_hz, dt_s_);
  const double quick_share = LowPassShare(kQuicker * params_.push_cutoff_hz, dt_s_);
  force_N_ += share * (unexplained_N - force_N_);
  quick_N_ += quick_share * (unexplained_N - quick_N_);
  const double all = force_N_.squaredNorm(), left = quick_N_.dot(force_N_);
  if (left < kGone * all) force_N_ *= std::max(0.0, left) / all;
}

}  // namespace sidestep
