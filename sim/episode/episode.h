// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// episode: everything that decides how a run goes on, at one instant.
//
// A fork goes on as the original does, bit for bit, and neither disturbs the other: a map of pushes
// simulates what comes before the push once and forks there. What only looks on (the recorder, the
// dump of MPC problems) is no part of it and is forked beside it.

#include <memory>
#include <vector>

#include "controller/make_controller.h"
#include "sim/episode/clock_stage_timer.h"
#include "sim/scenario/scenario.h"
#include "sim/sensors/sensor_suite.h"
#include "sim/verdict/judge.h"
#include "sim/world/world.h"

namespace sidestep {

/// The parts of a run at the beginning of `tick`: all ticks before it are done. RunEpisode() moves
/// it on.
struct Episode {
  Scenario scenario;
  std::unique_ptr<World> world;
  SensorSuite sensors;
  std::unique_ptr<ClockStageTimer> timer;  ///< Where the controller reports its stages.
  std::unique_ptr<Controller> controller;
  Judge judge;
  Tick tick{0};
  bool is_over{false};  ///< Nothing comes after `tick`, which is done too.

  /// Time at `tick` (s).
  double time_s() const { return SecondsAt(tick, scenario.world.step_s); }
};

/// What a controller is told of a scenario: the nominal robot, its settings and its gait.
ControllerSetup SetupOf(const Scenario& scenario);

/// The scenario's run before its first tick, under a controller of `make_controller`.
/// @throws ConfigError if the robot does not compile or lacks a part that the scenario names.
Episode StartEpisode(const Scenario& scenario,
                     const ControllerFactory& make_controller = MakeController);

/// A copy that shares nothing with `episode` that either changes.
Episode Fork(const Episode& episode);

/// A copy in which other pushes act than in `episode`, of which none may have begun. From there it
/// goes on as a run of the scenario with these pushes would, bit for bit: the part before a push
/// is simulated once for many of them.
///
/// Give `pushes` as many as the episode has: sums over loads take zeros in, and only an equal
/// number of them is sure to round alike.
/// @throws ContractViolation unless every push, old and new, starts after `episode.tick` (at it, if
///         that is 0: nothing was simulated yet). @throws ConfigError for a body that the robot
///         lacks.
Episode ForkWithPushes(const Episode& episode, const std::vector<Push>& pushes);

}  // namespace sidestep
