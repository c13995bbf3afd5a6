// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// centroidal_controller: the control chain of the centroidal plant, which has no joints: measured
// CoM and momentum -> schedule -> plan -> feet, and the plan's forces and footholds are the
// command.

#include <memory>
#include <string>

#include "controller/controller.h"
#include "controller/estimator/truth_estimator.h"
#include "controller/motion_chain.h"

namespace sidestep {

/// The same chain without its last link: what the MPC plans is exactly what the plant is given, so
/// failures of a scenario here are those of planner and MPC alone. ControlParams::estimator and the
/// blocks of the whole-body control are not read.
class CentroidalController final : public Controller {
 public:
  /// `timer` must outlive the controller. The robot's mass_kg must be known.
  CentroidalController(const ControllerSetup& setup, StageTimer* timer);

  const ControlTick& Update(const SensorFrame& frame) override;
  std::unique_ptr<Controller> Clone(StageTimer* timer) const override;
  std::string LastProblemJson(const std::string& name) const override {
    return chain_.LastProblemJson(name);
  }

 private:
  /// The measured reduced state as a belief: base at the CoM and upright, no joints.
  const RobotState& Estimate(const SensorFrame& frame);

  StageTimer* timer_;  ///< Not owned.
  CentroidalEstimator estimator_;
  MotionChain chain_;
  ControlTick tick_;  ///< The last answer, written in place.
};

}  // namespace sidestep
