// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// passive_controller: does nothing. The negative control of every scenario.

#include <memory>

#include "controller/controller.h"

namespace sidestep {

/// Commands zero torque, or zero force on the centroidal plant; believes and plans nothing.
class PassiveController final : public Controller {
 public:
  /// Reads nothing but is_centroidal.
  explicit PassiveController(const ControllerSetup& setup);

  /// As many zero torques as the frame has joints; on the centroidal plant a command without feet.
  const ControlTick& Update(const SensorFrame& frame) override;
  /// The timer is not used: there are no stages.
  std::unique_ptr<Controller> Clone(StageTimer* timer) const override;

 private:
  bool is_centroidal_;
  ControlTick tick_;
};

}  // namespace sidestep
