// SPDX-License-Identifier: BSD-3-Clause
#include "controller/centroidal_controller.h"

#include "controller/make_stages.h"
#include "controller/wbc/centroidal_command.h"

namespace sidestep {

CentroidalController::CentroidalController(const ControllerSetup& setup, StageTimer* timer)
    : timer_(timer),
      estimator_(static_cast<int>(setup.robot.feet.size()), setup.robot.mass_kg,
                 setup.control.estimation.contact_threshold_N, setup.control.external_wrench),
      chain_(setup, PlannedRobot(setup.robot, setup.robot.mass_kg), StandingRule::kAsScheduled) {}

const ControlTick& CentroidalController::Update(const SensorFrame& frame) {
  const Tick now = tick_.tick = frame.tick;
  const RobotState& state = Estimate(frame);
  chain_.Schedule(state, now, timer_);
  chain_.Plan(state, Eigen::Vector3d::Zero(), now, timer_);  // it has no attitude to level
  const std::vector<FootTarget>& feet = chain_.TargetFeet(state, now, timer_);
  chain_.WriteTo(&tick_);
  const ScopedStage stage(timer_, Stage::kWholeBody);
  wbc::WriteCentroidalCommand(feet, &tick_.command);
  return tick_;
}

const RobotState& CentroidalController::Estimate(const SensorFrame& frame) {
  const ScopedStage stage(timer_, Stage::kEstimator);
  tick_.state = estimator_.Update(frame);
  return tick_.state;
}

std::unique_ptr<Controller> CentroidalController::Clone(StageTimer* timer) const {
  auto copy = std::make_unique<CentroidalController>(*this);
  copy->timer_ = timer;
  return copy;
}

}  // namespace sidestep
