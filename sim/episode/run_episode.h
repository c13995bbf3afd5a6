// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// run_episode: one scenario from first tick to last. Read the .cc first of all files.

#include <functional>

#include "sim/record/problem_dump.h"
#include "sim/record/recorder.h"
#include "sim/scenario/scenario.h"
#include "sim/verdict/judge.h"
#include "sim/world/world.h"

namespace sidestep {

/// Called now and then with the simulated time so far.
using EpisodeProgress = std::function<void(double sim_time_s, double duration_s)>;

/// Runs `scenario` on `world` until its duration is over, the judge has seen enough, the physics
/// diverged, or the user interrupts. Returns the simulated time (s). Judge, recorder and dump
/// then hold what happened; none of them can disturb the run.
double RunEpisode(const Scenario& scenario, World* world, Judge* judge, Recorder* recorder,
                  ProblemDump* dump, const EpisodeProgress& progress);

}  // namespace sidestep
