// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// judge: watches every tick of a run and says what it showed.
//
// In : WorldTruth every tick, beside the scenario's nominal motion. ControlTick on control ticks,
// if the controller
//      tells what it thought: it makes the metrics of the group `controller` and
//      the SOLVER rule, and no other figure.
// Out: metrics, footsteps, push impulses and the verdict.
// Flow: world, controller -> [judge] -> recorder, command line.
//
// Rules (bounds from the scenario's `verdict:` block; W's z = 0 is the ground):
//   FALL    base lower than min_base_height_ratio x nominal height (the CoM on the centroidal
//           plant), tilted by more than max_tilt_rad from its attitude at the start, or a body
//           other than a foot on the ground.
//   SLIP    a foot slides by more than max_slip_m in one stance, before any fall.
//   SOLVER  before any fall the MPC fails more than five times in a row, or a solver (MPC, whole
//           body, a baseline's step) in more than 5 % of its solves and more than five times.
//   EXPECTATION   one per expectation that is not met.
// A scenario that expects `fall: true` (`slip: true`) is not failed by FALL (SLIP).

#include <memory>
#include <string>
#include <vector>

#include "controller/types/control_tick.h"
#include "controller/types/tick.h"
#include "sim/scenario/scenario.h"
#include "sim/verdict/meter_setup.h"
#include "sim/verdict/verdict.h"
#include "sim/world/world.h"

namespace sidestep {

class Judge {
 public:
  /// @param expect  Expectations, in the order in which missed ones are told.
  Judge(const MeterSetup& setup, std::vector<Expectation> expect);
  /// A judge that has seen what `other` has, and goes on by itself.
  Judge(const Judge& other);
  Judge& operator=(const Judge& other);
  Judge(Judge&&) noexcept;
  Judge& operator=(Judge&&) noexcept;
  ~Judge();

  /// Takes one tick, in order, each once, from 0 to the end of the run, the last one included.
  /// @param truth    State at `tick`, with the pushes that act from it.
  /// @param control  What the controller thought at `tick`; null between control ticks, and always
  ///                 for a controller that tells nothing.
  /// A non-finite CoM or base makes the run INVALID (DIVERGED) and ends the judging.
  void Add(Tick tick, const WorldTruth& truth, const ControlTick* control);

  /// Other pushes instead of those it has. None of either may have started by the tick after the
  /// last one taken.
  void ReplacePushes(const std::vector<Push>& pushes);

  /// Whether the robot is settled as of the last tick: it has not fallen, and what makes a push
  /// recovered from (push_meter.h: path, speed over the last gait cycle, tilt) holds. False before
  /// the first tick.
  bool is_settled() const;

  /// Makes the run INVALID. `kind` is reason::kDiverged, kInterrupted or kError.
  void Invalidate(const std::string& kind, const std::string& text, double time_s);

  /// True once nothing is left to learn: invalid, or half a second after a fall.
  bool finished() const;

  /// Verdict and measures of the ticks so far.
  RunOutcome Conclude() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace sidestep
