// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// synthetic_run: writes run folders without running anything, for tests of render, plot, report.
//
// A two-legged toy sways over its feet; from push_start_s on it is pushed to the left for
// push_duration_s, steps aside with the right foot and ends as the test wants.

#include <filesystem>
#include <string>

#include "sim/verdict/verdict.h"

namespace sidestep::testing {

struct SyntheticRun {
  std::string name{"toy_push_left"};
  VerdictClass verdict{VerdictClass::kPass};  ///< FAIL comes with a reason FALL at the run's end.
  double duration_s{0.5};
  double dt_s{0.01};
  double push_start_s{0.2};
  double push_duration_s{0.1};
  double push_force_N{40.0};  ///< Along +y, at the trunk's side.
};

/// Creates `dir` with all files that a run leaves but video, plots and report.
void WriteSyntheticRun(const std::filesystem::path& dir, const SyntheticRun& run = {});

/// Gives the feet of such a run the soles of the biped, rectangles, in place of the toy's points.
void GiveItSoles(const std::filesystem::path& dir);

/// A fresh empty folder for the running test, under the system's temporary folder. The same
/// test asking again gets it emptied.
std::filesystem::path FreshTestDir(const std::string& name);

}  // namespace sidestep::testing
