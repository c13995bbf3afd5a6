// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// controller: the door between the simulation and whatever controls the robot.
//
// In : a SensorFrame every control tick, nothing else.
// Out: an ActuatorCommand and, for the log, what the controller thought.
// The simulation knows controllers by this file alone; make_controller.h makes those that ship, and
// controller/example shows one of a user's own.

#include <memory>
#include <string>
#include <vector>

#include "controller/types/control_params.h"
#include "controller/types/control_tick.h"
#include "controller/types/gait_params.h"
#include "controller/types/sensor_frame.h"
#include "controller/types/stage_timer.h"
#include "models/robot_description/robot_description.h"

namespace sidestep {

/// What a controller is made from. The robot is the nominal one: the plant may differ from it.
struct ControllerSetup {
  RobotDescription robot;
  ControlParams control;
  std::vector<GaitParams> gait;  ///< What the robot is asked to do, by start_s; the first at 0.
  bool is_centroidal{false};     ///< The plant has no joints: forces at the feet are the command.
  double tick_s{0.001};          ///< One tick.
};

/// One controller of one robot.
class Controller {
 public:
  virtual ~Controller() = default;

  /// One control tick: called every 1 / control.rate_hz seconds, first at tick 0, with ascending
  /// ticks. Must answer ControlTick::command; whatever else it leaves empty is empty in the log.
  /// The reference stays valid until the next call. Reads no clock, draws no random number, does
  /// not allocate once every size has been seen.
  virtual const ControlTick& Update(const SensorFrame& frame) = 0;

  /// A copy that from here on answers the same frames with the same commands, bit for bit, and
  /// shares nothing with this one that either changes: runs are forked at a push.
  /// @param timer  Where the copy reports its stages; must outlive it.
  virtual std::unique_ptr<Controller> Clone(StageTimer* timer) const = 0;

  /// The optimisation problem behind the last ControlTick whose mpc.ran is true, as the JSON text
  /// that `sidestep solve` reads; empty if the controller solves none.
  /// @param name  What the document calls itself.
  virtual std::string LastProblemJson(const std::string& /*name*/) const { return {}; }

 protected:
  Controller() = default;
  Controller(const Controller&) = default;
  Controller& operator=(const Controller&) = default;
};

}  // namespace sidestep
