// SPDX-License-Identifier: BSD-3-Clause
// The table of contents of the program:
//   [World -> sensors -> CONTROLLER -> World]* with judge and recorder looking on.
// No maths here: every line is one wall crossing. Time is an integer tick.

#include "sim/episode/run_episode.h"

#include <chrono>
#include <nlohmann/json.hpp>

#include "controller/locomotion_controller.h"
#include "controller/mpc/problem/ocp_json.h"
#include "sim/episode/interrupt.h"
#include "sim/episode/wall_stage_timer.h"
#include "sim/sensors/sensor_suite.h"

namespace sidestep {
namespace {

constexpr double kProgressPeriod_s = 0.1;  // simulated

LocomotionSetup SetupOf(const Scenario& scenario) {
  return {scenario.description_of_robot,        scenario.control,      scenario.gait,
          scenario.plant == Plant::kCentroidal, scenario.world.step_s, scenario.duration_s};
}

double ElapsedMs(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
      .count();
}

std::string ProblemJson(const mpc::CentroidalOcp& ocp, const std::string& name) {
  nlohmann::json problem = mpc::ToJson(ocp);
  problem["name"] = name;
  return problem.dump(1) + "\n";
}

// Why a run that ended early says nothing of the controller, if so.
void NoteInvalid(const World& world, double time_s, Judge* judge) {
  if (!world.is_valid()) judge->Invalidate(reason::kDiverged, world.invalid_reason(), time_s);
  if (InterruptRequested()) judge->Invalidate(reason::kInterrupted, "stopped by the user", time_s);
}

}  // namespace

double RunEpisode(const Scenario& scenario, World* world, Judge* judge, Recorder* recorder,
                  ProblemDump* dump, const EpisodeProgress& progress) {
  const double tick_s = scenario.world.step_s;
  const Tick num_ticks = TickAt(scenario.duration_s, tick_s);
  const Tick control_period = TickAt(1.0 / scenario.control.rate_hz, tick_s);
  const Tick progress_period = TickAt(kProgressPeriod_s, tick_s);
  WallStageTimer timer;
  SensorSuite sensors = MakeSensorSuite(scenario, world->mass_kg());
  LocomotionController controller(SetupOf(scenario), &timer);  // sees SensorFrame, never World

  Tick tick = 0;
  for (;; ++tick) {
    const ControlTick* control = nullptr;
    if (tick % control_period == 0) {
      const SensorFrame frame = sensors.Read(world->truth(), tick);
      timer.Reset();
      const auto start = std::chrono::steady_clock::now();
      control = &controller.Update(frame);
      const WallTimes wall{ElapsedMs(start), timer.Spent_ms(Stage::kMpc),
                           timer.Spent_ms(Stage::kWholeBody)};
      recorder->Add(tick, world->truth(), *control, wall);
      if (control->mpc.ran) {
        dump->Add(SecondsAt(tick, tick_s), control->mpc.fell_back, [&](const std::string& name) {
          return ProblemJson(controller.last_problem(), name);
        });
      }
      world->Apply(control->command);
    }
    judge->Add(tick, world->truth(), control);
    if (tick % progress_period == 0 && progress) {
      progress(SecondsAt(tick, tick_s), scenario.duration_s);
    }
    if (tick == num_ticks || judge->finished() || !world->is_valid() || InterruptRequested()) break;
    world->Step(tick);
    sensors.Accumulate(world->truth());
  }
  NoteInvalid(*world, SecondsAt(tick, tick_s), judge);
  return SecondsAt(tick, tick_s);
}

}  // namespace sidestep
