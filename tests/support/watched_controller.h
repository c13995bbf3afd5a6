// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// watched_controller: looks over a controller's shoulder in the program's own loop.

#include <functional>
#include <memory>
#include <utility>

#include "sim/episode/run_episode.h"

namespace sidestep {

/// Called with every frame in place of the controller's Update(), beside the truth of that tick.
/// Must return controller->Update(frame).
using Watch = std::function<const ControlTick&(const SensorFrame& frame, Controller* controller,
                                               const WorldTruth& truth)>;

namespace internal {

class WatchedController final : public Controller {
 public:
  using Answer = std::function<const ControlTick&(const SensorFrame&, Controller*)>;

  WatchedController(std::unique_ptr<Controller> controller, Answer answer)
      : controller_(std::move(controller)), answer_(std::move(answer)) {}

  const ControlTick& Update(const SensorFrame& frame) override {
    return answer_(frame, controller_.get());
  }

  std::unique_ptr<Controller> Clone(StageTimer* timer) const override {
    return std::make_unique<WatchedController>(controller_->Clone(timer), answer_);
  }

 private:
  std::unique_ptr<Controller> controller_;
  Answer answer_;
};

}  // namespace internal

/// Runs `scenario` under its own controller for `duration_s`, or until it is over.
inline void RunWatched(const Scenario& scenario, double duration_s, const Watch& watch) {
  const World* world = nullptr;
  const internal::WatchedController::Answer answer =
      [&](const SensorFrame& frame, Controller* controller) -> const ControlTick& {
    return watch(frame, controller, world->truth());
  };
  Episode episode = StartEpisode(scenario, [&](const ControllerSetup& setup, StageTimer* timer) {
    return std::make_unique<internal::WatchedController>(MakeController(setup, timer), answer);
  });
  world = episode.world.get();
  RunEpisode(&episode, {}, TickAt(duration_s, scenario.world.step_s));
}

}  // namespace sidestep
