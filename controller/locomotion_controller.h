// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// locomotion_controller: the control chain of a robot with joints. Read the .cc: it is the table of
// contents.

#include <memory>
#include <string>

#include "controller/controller.h"
#include "controller/estimator/state_estimator.h"
#include "controller/model/rigid_body.h"
#include "controller/motion_chain.h"
#include "controller/wbc/whole_body.h"
#include "models/support/clone_ptr.h"

namespace sidestep {

/// Sensors -> belief -> schedule -> plan -> feet -> joints, once a control tick, for torque and
/// position mode alike: only the last link differs. A value but for the timer: Clone() copies every
/// link.
class LocomotionController final : public Controller {
 public:
  /// `timer` must outlive the controller. Throws ConfigError if the robot's MJCF does not compile.
  LocomotionController(const ControllerSetup& setup, StageTimer* timer);

  const ControlTick& Update(const SensorFrame& frame) override;
  std::unique_ptr<Controller> Clone(StageTimer* timer) const override;
  std::string LastProblemJson(const std::string& name) const override {
    return chain_.LastProblemJson(name);
  }

 private:
  /// Leaves body_ at the belief, which the links behind it read.
  const RobotState& Estimate(const SensorFrame& frame);
  /// h*[0] (kg m^2/s, about C, in W) on ticks of a solve; see momentum_reference.h.
  Eigen::Vector3d LevellingMomentumAt(Tick tick, const RobotState& state) const;

  double attitude_rate_radps_;          ///< MpcParams' own.
  StageTimer* timer_;                   ///< Not owned.
  RigidBody body_;                      ///< The nominal robot, at the belief.
  ClonePtr<StateEstimator> estimator_;  ///< By ControlParams::estimator.
  MotionChain chain_;
  ClonePtr<wbc::WholeBody> whole_body_;  ///< By ControlParams::mode.
  ControlTick tick_;                     ///< The last answer, written in place.
};

}  // namespace sidestep
