// SPDX-License-Identifier: BSD-3-Clause
// The table of contents of the program:
//   [World -> sensors -> CONTROLLER -> World]* with judge and recorder looking on.
// No maths here: every line is one wall crossing. Time is an integer tick.

#include "sim/episode/run_episode.h"

#include "sim/process/interrupt.h"

namespace sidestep {
namespace {

constexpr double kProgressPeriod_s = 0.1;  // simulated

// Asks the controller; its answer lives until it is asked again.
const ControlTick& Ask(Controller* controller, const SensorFrame& frame, ClockStageTimer* timer,
                       TickTimes* times) {
  timer->Reset();
  const ClockReading start = ClockReading::Now();
  const ControlTick& control = controller->Update(frame);
  *times = {ClockReading::Now().Since(start), timer->Spent(Stage::kMpc),
            timer->Spent(Stage::kWholeBody)};
  return control;
}

void Show(const Episode& episode, const ControlTick& control, const TickTimes& times,
          const Onlookers& onlookers) {
  if (onlookers.recorder != nullptr) {
    onlookers.recorder->Add(episode.tick, episode.world->truth(), control, times);
  }
  if (onlookers.dump != nullptr && control.mpc.ran) {
    onlookers.dump->Add(episode.time_s(), control.mpc.fell_back, [&](const std::string& name) {
      return episode.controller->LastProblemJson(name);
    });
  }
}

// Why a run that ended early says nothing of the controller, if so.
void NoteInvalid(Episode* episode) {
  const World& world = *episode->world;
  Judge& judge = episode->judge;
  if (!world.is_valid()) {
    judge.Invalidate(reason::kDiverged, world.invalid_reason(), episode->time_s());
  }
  if (InterruptRequested()) {
    judge.Invalidate(reason::kInterrupted, "stopped by the user", episode->time_s());
  }
}

}  // namespace

void RunEpisode(Episode* episode, const Onlookers& onlookers, Tick until) {
  const Scenario& scenario = episode->scenario;
  const double tick_s = scenario.world.step_s;
  const Tick num_ticks = TickAt(scenario.duration_s, tick_s);
  const Tick control_period = TickAt(1.0 / scenario.control.rate_hz, tick_s);
  const Tick progress_period = TickAt(kProgressPeriod_s, tick_s);
  World& world = *episode->world;

  while (!episode->is_over && episode->tick < until) {
    const Tick tick = episode->tick;
    const ControlTick* control = nullptr;
    if (tick % control_period == 0) {
      const SensorFrame frame = episode->sensors.Read(world.truth(), tick);
      TickTimes times;
      control = &Ask(episode->controller.get(), frame, episode->timer.get(), &times);
      Show(*episode, *control, times, onlookers);
      world.Apply(control->command);
    }
    episode->judge.Add(tick, world.truth(), control);
    if (tick % progress_period == 0 && onlookers.progress) {
      onlookers.progress(episode->time_s(), scenario.duration_s);
    }
    episode->is_over =
        tick == num_ticks || episode->judge.finished() || !world.is_valid() || InterruptRequested();
    if (episode->is_over) break;
    world.Step(tick);
    episode->sensors.Accumulate(world.truth());
    ++episode->tick;
  }
  if (episode->is_over) NoteInvalid(episode);
}

}  // namespace sidestep
