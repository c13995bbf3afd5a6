// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// run_episode: one scenario from first tick to last. Read the .cc first of all files.

#include <functional>
#include <limits>

#include "sim/episode/episode.h"
#include "sim/record/problem_dump.h"
#include "sim/record/recorder.h"

namespace sidestep {

/// Called now and then with the simulated time so far.
using EpisodeProgress = std::function<void(double sim_time_s, double duration_s)>;

/// Those who look on; each may be absent. None of them can disturb the run.
struct Onlookers {
  Recorder* recorder{nullptr};  ///< Takes every control tick.
  ProblemDump* dump{nullptr};   ///< Takes every solve of the MPC.
  EpisodeProgress progress;
};

/// Moves `episode` on until its duration is over, the judge has seen enough, the physics diverged
/// or the user interrupts; or, if none of that comes before, to the beginning of tick `until`.
void RunEpisode(Episode* episode, const Onlookers& onlookers,
                Tick until = std::numeric_limits<Tick>::max());

}  // namespace sidestep
