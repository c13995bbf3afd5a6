// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// control_loop: a controller on MuJoCo's world, without judge and recorder.

#include "controller/locomotion_controller.h"
#include "sim/scenario/scenario.h"
#include "sim/sensors/sensor_suite.h"
#include "sim/world/make_world.h"
#include "sim/world/mujoco_world.h"

namespace sidestep {

/// Runs `scenario` for `duration_s` and calls look(tick, frame, &controller, truth), which must
/// return controller->Update(frame), at every control tick.
template <typename Look>
void RunControlLoop(const Scenario& scenario, double duration_s, Look&& look) {
  const double tick_s = scenario.world.step_s;
  const Tick control_period = TickAt(1.0 / scenario.control.rate_hz, tick_s);
  MujocoWorld world = MakeMujocoWorld(scenario);
  SensorSuite sensors = MakeSensorSuite(scenario, world.mass_kg());
  StageTimer timer;
  LocomotionController controller({scenario.description_of_robot, scenario.control, scenario.gait,
                                   false, tick_s, scenario.duration_s},
                                  &timer);
  for (Tick tick = 0; tick < TickAt(duration_s, tick_s); ++tick) {
    if (tick % control_period == 0) {
      const SensorFrame frame = sensors.Read(world.truth(), tick);
      const ControlTick& control = look(tick, frame, &controller, world.truth());
      world.Apply(control.command);
    }
    world.Step(tick);
    sensors.Accumulate(world.truth());
  }
}

}  // namespace sidestep
