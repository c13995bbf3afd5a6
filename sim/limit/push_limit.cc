// SPDX-License-Identifier: BSD-3-Clause
#include "sim/limit/push_limit.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "models/support/require.h"
#include "sim/limit/hopping_pendulum.h"
#include "sim/limit/manoeuvres.h"
#include "sim/limit/walking_pendulum.h"

namespace sidestep::limit {
namespace {

// Below this share of it in an axis, a push does nothing there.
constexpr double kAcross = 1e-9;
constexpr double kOnTheEdge_m = 1e-9;

/// Strengths (m/s) of a push, of which the share `along` acts in this axis, that leave a DCM at
/// `dcm_m` in `captured`.
Interval StrengthsInto(const Interval& captured, double dcm_m, double along, double omega_per_s) {
  if (captured.is_empty()) return {};
  if (std::abs(along) < kAcross) {
    const Interval widened{captured.lo - kOnTheEdge_m, captured.hi + kOnTheEdge_m};
    return widened.contains(dcm_m) ? kWholeLine : Interval{};
  }
  const double at_lo = (captured.lo - dcm_m) * omega_per_s / along;
  const double at_hi = (captured.hi - dcm_m) * omega_per_s / along;
  return {std::min(at_lo, at_hi), std::max(at_lo, at_hi)};
}

/// A landing place along one axis with the strengths that it captures.
struct Candidate {
  std::size_t place;
  Interval strengths;
};

/// Those that reach beyond `best`.
void ListBetter(const std::vector<Interval>& captured, double dcm_m, double along,
                double omega_per_s, double best, std::vector<Candidate>* candidates) {
  candidates->clear();
  for (std::size_t place = 0; place < captured.size(); ++place) {
    const Interval strengths = StrengthsInto(captured[place], dcm_m, along, omega_per_s);
    if (!strengths.is_empty() && strengths.hi > best) candidates->push_back({place, strengths});
  }
}

/// Raises the largest strength of each direction as manoeuvres are shown to it.
class LargestStrengths {
 public:
  LargestStrengths(const LimitTask& task, const Eigen::Vector2d& dcm_m)
      : task_(task), dcm_m_(dcm_m), best_(task.directions_rad.size(), 0.0) {}

  void Weigh(const CaptureSets& sets) {
    for (std::size_t i = 0; i < best_.size(); ++i) Weigh(sets, task_.directions_rad[i], &best_[i]);
  }

  const std::vector<double>& best() const { return best_; }

 private:
  void Weigh(const CaptureSets& sets, double direction_rad, double* best) {
    const double omega = task_.params.omega_per_s;
    ListBetter(sets.x, dcm_m_.x(), std::cos(direction_rad), omega, *best, &along_x_);
    if (along_x_.empty()) return;
    ListBetter(sets.y, dcm_m_.y(), std::sin(direction_rad), omega, *best, &along_y_);
    for (const Candidate& x : along_x_) {
      for (const Candidate& y : along_y_) {
        const double most = std::min(x.strengths.hi, y.strengths.hi);
        if (most <= *best || most < std::max(x.strengths.lo, y.strengths.lo)) continue;
        if (std::isfinite(most) && sets.MayLand(x.place, y.place)) *best = most;
      }
    }
  }

  const LimitTask& task_;
  Eigen::Vector2d dcm_m_;
  std::vector<double> best_;
  std::vector<Candidate> along_x_;
  std::vector<Candidate> along_y_;
};

std::vector<StepFreedom> FreedomsUpTo(StepFreedom most) {
  std::vector<StepFreedom> freedoms;
  for (const StepFreedom freedom : EnumValues<StepFreedom>()) {
    freedoms.push_back(freedom);
    if (freedom == most) break;
  }
  return freedoms;
}

std::vector<std::vector<double>> WalkLimits(const LimitTask& task) {
  std::vector<Manoeuvres> choices;
  for (const StepFreedom freedom : FreedomsUpTo(task.freedom)) {
    choices.emplace_back(task.params, task.is_planar, freedom);
  }
  std::vector<std::vector<double>> limits;
  for (const PushMoment& moment : task.moments) {
    const PendulumState state =
        task.gait == GaitType::kStand ? StandOf(task.params) : WalkAt(task.params, moment.time_s);
    LargestStrengths largest(task, state.dcm_m);
    for (const Manoeuvres& choice : choices) {
      choice.VisitAll(state, [&](const CaptureSets& sets) { largest.Weigh(sets); });
    }
    limits.push_back(largest.best());
  }
  return limits;
}

std::vector<std::vector<double>> HopLimits(const LimitTask& task) {
  std::vector<std::vector<double>> limits;
  for (const PushMoment& moment : task.moments) {
    const bool may_step = task.freedom != StepFreedom::kNone;
    const double limit_mps = may_step ? HopLimit(task.params, moment.time_s) : 0.0;
    limits.emplace_back(task.directions_rad.size(), limit_mps);
  }
  return limits;
}

}  // namespace

std::vector<std::vector<double>> LargestVelocitySteps(const LimitTask& task) {
  SIDESTEP_REQUIRE(task.gait != GaitType::kRun, static_cast<int>(task.gait));
  return task.gait == GaitType::kHop ? HopLimits(task) : WalkLimits(task);
}

double HeldPushFactor(double omega_per_s, double duration_s) {
  const double x = omega_per_s * duration_s;
  return x > 0.0 ? x / -std::expm1(-x) : 1.0;
}

}  // namespace sidestep::limit
