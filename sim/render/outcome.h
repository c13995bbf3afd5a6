// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// outcome: how a run ended, in the few words that stand over it in a film of two.

#include <Eigen/Core>
#include <string>

#include "sim/record/run_summary.h"

namespace sidestep::render {

/// What to say, on which colour, and from when on.
struct Outcome {
  std::string text;
  Eigen::Vector3f color{Eigen::Vector3f::Zero()};  ///< Of the box below it; see caption_colors.h.
  double from_s{0.0};                              ///< Of the run's time.
};

/// The robot fell, whatever the scenario expected of it.
bool HasFallen(const RunSummary& summary);

/// A robot that fell: when, in red from then on, even if that was expected. One that
/// recovered from all its pushes: how fast, in green from then on. Else the verdict, in its colour
/// during the run's last second.
Outcome OutcomeOf(const RunSummary& summary);

}  // namespace sidestep::render
