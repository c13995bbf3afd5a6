// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// capture_kernel: which DCMs a walking pendulum can hold for ever, one axis at a time.
//
// In : the places of feet along one axis, the times of steps.
// Out: for each place of the other foot at lift-off, the interval of DCMs that can be held.
// A set of them before a step follows from that after it: the foot lands in some place that it
// gets to; the centre of pressure stays in the sole while it swings, and between the ends of both
// soles while both stand. Many steps back from anything at all, the set no longer changes.
// Axes are coupled by their times alone; so this asks for no less than a robot that can't do both
// at once needs, and the limit that comes of it is an upper bound.
//
// Source: T. Koolen, T. de Boer, J. Rebula, A. Goswami, J. Pratt, "Capturability-based analysis and
// control of legged locomotion, Part 1", Int. J. of Robotics Research 31(9), 2012: infinite-step
// capture of the linear pendulum with a finite foot; here with more than one time to step.

#include <vector>

#include "sim/limit/interval.h"
#include "sim/limit/step_axis.h"

namespace sidestep::limit {

/// By index of StepAxis::origins_m: the DCMs (m, in the step's frame) at lift-off that are held.
using Kernel = std::vector<Interval>;

/// A swing, and the time on both feet after it.
struct StepTimes {
  double swing_s{0.0};
  double support_s{0.0};
};

/// What can be led into `after`, the next step's, by a step of these times.
Kernel BeforeStep(const StepAxis& axis, double omega_per_s, const StepTimes& times,
                  const Kernel& after);

/// What can be held by steps of these times for ever.
Kernel HeldForEver(const StepAxis& axis, double omega_per_s, const StepTimes& times);

/// Kernels for two swings of any of `swings_s` and then all of one of them, for ever: one for every
/// choice, in an order that depends on nothing but `swings_s`, so that those of two axes pair up.
std::vector<Kernel> KernelsOf(const StepAxis& axis, double omega_per_s,
                              const std::vector<double>& swings_s, double support_s);

}  // namespace sidestep::limit
