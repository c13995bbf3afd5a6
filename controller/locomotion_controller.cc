// SPDX-License-Identifier: BSD-3-Clause
// The control chain. Every link is a room of its own; this file hands values from one to the next.

#include "controller/locomotion_controller.h"

#include "controller/make_stages.h"
#include "controller/planner/momentum_reference.h"

namespace sidestep {

LocomotionController::LocomotionController(const ControllerSetup& setup, StageTimer* timer)
    : attitude_rate_radps_(setup.control.mpc.attitude_rate_radps),
      timer_(timer),
      body_(setup.robot),
      estimator_(MakeEstimator(setup, body_)),
      chain_(setup, PlannedRobot(setup.robot, body_), StandingRule::kWhenFelt),
      whole_body_(MakeWholeBody(setup, body_)) {}

const ControlTick& LocomotionController::Update(const SensorFrame& frame) {
  const Tick now = tick_.tick = frame.tick;
  // What is: base, joints, feet, the push that is felt.
  const RobotState& state = Estimate(frame);
  // Which foot stands where and when, from now to the horizon.
  chain_.Schedule(state, now, timer_);
  // How CoM and forces should go, and where the coming steps should be after all.
  const ComTarget& com = chain_.Plan(state, LevellingMomentumAt(now, state), now, timer_);
  // Where each foot should be at this instant.
  const std::vector<FootTarget>& feet = chain_.TargetFeet(state, now, timer_);
  chain_.WriteTo(&tick_);
  // What the joints must do for that.
  const ScopedStage stage(timer_, Stage::kWholeBody);
  tick_.wbc = whole_body_->Solve(state, body_, com, feet, &tick_.command);
  return tick_;
}

const RobotState& LocomotionController::Estimate(const SensorFrame& frame) {
  const ScopedStage stage(timer_, Stage::kEstimator);
  tick_.state = estimator_->Update(frame, &body_);
  return tick_.state;
}

// Zero between solves, when nobody reads it and the mass matrix would be made for nothing.
Eigen::Vector3d LocomotionController::LevellingMomentumAt(Tick tick,
                                                          const RobotState& state) const {
  if (!chain_.SolvesAt(tick)) return Eigen::Vector3d::Zero();
  return LevellingMomentum(state.q_WB, body_.base_inertia(), attitude_rate_radps_);
}

std::unique_ptr<Controller> LocomotionController::Clone(StageTimer* timer) const {
  auto copy = std::make_unique<LocomotionController>(*this);
  copy->timer_ = timer;
  return copy;
}

}  // namespace sidestep
