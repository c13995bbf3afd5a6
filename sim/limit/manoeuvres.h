// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// manoeuvres: what a pushed pendulum may do, as sets of DCMs that it gets away with.
//
// A manoeuvre is the first step after a push: when its foot lands, where, where on the line between
// both feet the centre of pressure is until the next lift-off, and which steps come after it (or
// that none does and the robot stands). Unlike later steps this one couples the axes: the foot has
// one speed, both feet one line, and a crossing foot must clear the other.

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "sim/limit/capture_kernel.h"
#include "sim/limit/limit_params.h"
#include "sim/limit/step_axis.h"
#include "sim/limit/walking_pendulum.h"

namespace sidestep::limit {

/// The DCMs (m, in the frame of the pushed pendulum) that one manoeuvre captures, for each landing
/// place of each axis: x[i] and y[j] together, where may_land(i, j).
struct CaptureSets {
  std::vector<Interval> x;
  std::vector<Interval> y;
  const std::vector<char>* may_land{nullptr};  ///< x-major; null: all.

  bool MayLand(std::size_t i, std::size_t j) const {
    return may_land == nullptr || (*may_land)[i * y.size() + j] != 0;
  }
};

/// The manoeuvres of a pendulum whose steps give way as `freedom` says.
class Manoeuvres {
 public:
  using Visit = std::function<void(const CaptureSets&)>;

  /// `freedom` is taken at its word: kFree leaves out what only the gait's own times allow.
  Manoeuvres(const LimitParams& params, bool is_planar, StepFreedom freedom);

  /// Calls `visit` for every manoeuvre that starts at `state`.
  void VisitAll(const PendulumState& state, const Visit& visit) const;

 private:
  /// A step that is about to be made, in the frame of the foot that stands throughout it.
  struct Step {
    double until_landing_s{0.0};
    bool lands_anyway{false};  ///< If no place can be reached, at the gait's: it comes to that.
    Eigen::Vector2d swinging_foot_m{0.0, 0.0};
  };

  void VisitSwing(const PendulumState& state, const Visit& visit) const;
  void VisitSupport(const PendulumState& state, const Visit& visit) const;

  /// Every way to go on from a landing, run back to the start of `step`.
  void VisitStep(const Step& step, const Visit& visit) const;
  /// As `visit`, for sets that hold at the end of `left_s` more on both feet, of `state`.
  void VisitShares(const PendulumState& state, double left_s, const CaptureSets& sets,
                   const Visit& visit) const;

  /// From the moment of landing: `kernel` of kernels_ after a time on both feet at `share` of the
  /// line between them or, beyond the last, standing there.
  CaptureSets AtLanding(std::size_t kernel, double share) const;
  std::vector<char> LandingsOf(const Step& step) const;
  std::vector<double> LandingTimes(const PendulumState& state) const;
  double Growth(double time_s) const;
  Interval SoleAlong(const StepAxis& axis, double foot_m) const;

  LimitParams params_;
  bool is_planar_;
  StepFreedom freedom_;
  StepAxis x_;
  StepAxis y_;
  std::vector<Kernel> x_kernels_;
  std::vector<Kernel> y_kernels_;
  double support_s_;
};

}  // namespace sidestep::limit
