// SPDX-License-Identifier: BSD-3-Clause
#include "tests/support/toy_motion.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sidestep::testing {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kHip_m = 0.5;     // trunk's origin above the floor
constexpr double kWidth_m = 0.16;  // between the feet

// Nominal and adjusted right foot; the left one never moves.
Eigen::Vector3d LeftFoot() { return {0.0, 0.5 * kWidth_m, 0.0}; }
Eigen::Vector3d RightFoot(bool next) { return {next ? 0.10 : 0.0, -0.5 * kWidth_m, 0.0}; }
Eigen::Vector3d RightAdjusted(bool next) {
  return RightFoot(next) + (next ? Eigen::Vector3d(0.02, 0.05, 0.0) : Eigen::Vector3d::Zero());
}

}  // namespace

Moment MomentAt(const SyntheticRun& run, double time_s) {
  Moment moment;
  const double since_s = time_s - run.push_start_s;
  if (since_s >= 0.0 && since_s < run.push_duration_s) moment.push_N.y() = run.push_force_N;
  const double impulse_mps = run.push_force_N * run.push_duration_s / kToyMass_kg;
  const double decay = since_s > 0.0 ? std::exp(-3.0 * since_s) : 0.0;
  const double drift_m = since_s > 0.0 ? impulse_mps * since_s * decay : 0.0;
  moment.v_WC << 0.1, impulse_mps * decay * (1.0 - 3.0 * std::max(0.0, since_s)), 0.0;
  moment.p_WC << 0.1 * time_s, 0.01 * std::sin(2.0 * kPi * time_s) + drift_m, 0.6;
  moment.swing = std::min(1.0, std::max(0.0, (since_s - run.push_duration_s) / kToySwing_s));
  moment.is_swinging = moment.swing > 0.0 && moment.swing < 1.0;
  moment.tilt_rad = 0.5 * drift_m;
  if (run.verdict == VerdictClass::kFail) moment.tilt_rad = 1.2 * time_s / run.duration_s;
  return moment;
}

std::vector<FootNow> FeetAt(const Moment& moment) {
  const bool next = moment.swing > 0.0;
  const double weight_N = 9.81 * kToyMass_kg;
  const double share = moment.is_swinging ? 1.0 : 0.5;
  const Eigen::Vector3d lift(0.0, 0.0, 0.05 * std::sin(kPi * moment.swing));
  const Eigen::Vector3d sideways = -0.2 * moment.push_N;
  FootNow left{"left", LeftFoot(), sideways, LeftFoot(), LeftFoot(), true};
  left.f_F_W.z() += share * weight_N;
  FootNow right{"right",
                RightFoot(false) + moment.swing * (RightAdjusted(true) - RightFoot(false)) + lift,
                Eigen::Vector3d::Zero(),
                RightFoot(next),
                RightAdjusted(next),
                !moment.is_swinging};
  if (right.is_down) right.f_F_W = sideways + Eigen::Vector3d(0, 0, 0.5 * weight_N);
  return {left, right};
}

Eigen::VectorXd QposAt(const Moment& moment) {
  Eigen::VectorXd qpos = Eigen::VectorXd::Zero(13);
  const double bend = 0.5 * std::sin(kPi * moment.swing);
  const double roll = -(moment.p_WC.y()) / kHip_m;
  qpos << moment.p_WC.x(), moment.p_WC.y(), kHip_m + 0.01, std::cos(0.5 * moment.tilt_rad),
      std::sin(-0.5 * moment.tilt_rad), 0.0, 0.0, roll, -0.1, 0.2, roll - 0.1 * moment.swing,
      -0.1 - bend, 0.2 + 2.0 * bend;
  return qpos;
}

}  // namespace sidestep::testing
