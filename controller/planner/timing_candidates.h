// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// timing_candidates: other courses that a pushed walk may take in time: who steps, and when.
//
// The capture point of a pushed pendulum runs away as e^(wt), w = sqrt(g / h): a step that comes
// 0.2 s later must be more than twice as long. Where feet land is the MPC's to decide; when they
// land is not, for its grid is made of contacts that are on or off. But there is not much to choose
// from: the foot in the air may land sooner; the next one may lift off sooner and swing quicker;
// and it need not be the one whose turn it was, as a step of the foot that is pushed away from
// helps nothing. One that stands may begin to step. Each choice is an edit of the gait
// (schedule_edits.h), to be weighed by the MPC.

#include <cstddef>
#include <vector>

#include "controller/planner/gait_setup.h"
#include "controller/planner/gait_support.h"

namespace sidestep {

/// What feet can do in time, in ticks.
struct TimingLimits {
  Tick step{50};           ///< Landings move by multiples of this: the MPC's grid.
  Tick least_swing{250};   ///< Shortest time in the air of a step that is still to begin.
  Tick least_rest{100};    ///< Shortest time until a foot in the air lands.
  Tick least_support{50};  ///< Shortest time on both feet.
};

/// Fills `candidates` with the other courses that the walk or stand which `support` is in may take
/// from `now` on, in an order that is always the same. None of other gaits or for one foot. At
/// least one foot stands throughout.
void ListTimingCandidates(const GaitSetup& setup, const GaitSupport& support, Tick now,
                          const TimingLimits& limits, std::vector<GaitSupport>* candidates);

/// No more candidates than this are ever listed.
std::size_t MostTimingCandidates(const GaitSetup& setup, const TimingLimits& limits);

}  // namespace sidestep
