// SPDX-License-Identifier: BSD-3-Clause
// The chain: estimator -> planner -> MPC -> swing -> whole-body. Every stage is a room of its own;
// this file only hands structs from one to the next.

#include "controller/locomotion_controller.h"

#include <cmath>

#include "controller/estimator/leg_odometry.h"
#include "controller/model/upright.h"
#include "controller/wbc/centroidal_command.h"
#include "controller/wbc/inverse_dynamics.h"
#include "controller/wbc/inverse_kinematics.h"

namespace sidestep {
namespace {

Tick HorizonTicks(const LocomotionSetup& setup) {
  return (setup.control.mpc.knots + 1) * TickAt(setup.control.mpc.step_s, setup.tick_s);
}

mpc::RobotModel MakeRobotModel(const LocomotionSetup& setup, const RigidBody* rigid_body) {
  mpc::RobotModel robot;
  robot.mass_kg = rigid_body != nullptr ? rigid_body->mass_kg() : setup.robot.mass_kg;
  if (rigid_body != nullptr) robot.gravity_mps2 = rigid_body->gravity_mps2();
  for (const FootDescription& foot : setup.robot.feet) {
    robot.foot_names.push_back(foot.name);
    robot.vertices_m.push_back(foot.vertices_m);
  }
  return robot;
}

GaitPlanner MakePlanner(const LocomotionSetup& setup, const mpc::RobotModel& robot) {
  const GaitGeometry geometry{static_cast<int>(setup.robot.feet.size()),
                              setup.robot.com_height_m,
                              setup.robot.feet.front().sole_height_m,
                              setup.control.mpc.box_lower_m,
                              setup.control.mpc.box_upper_m,
                              setup.control.planner.com_sway};
  const Tick horizon = HorizonTicks(setup);
  const Tick end = TickAt(setup.duration_s, setup.tick_s) + 2 * horizon;
  GaitPlanner planner(BuildNominalGait(setup.gait, geometry, end, setup.tick_s),
                      setup.control.planner, horizon, setup.tick_s);
  if (setup.control.planner.recovery.enabled && robot.vertices_m.size() == 2) {
    planner.EnableRecovery({setup.gait, geometry, end,
                            TickAt(setup.control.mpc.step_s, setup.tick_s), robot.mass_kg,
                            robot.vertices_m});
  }
  return planner;
}

std::unique_ptr<StateEstimator> MakeEstimator(const LocomotionSetup& setup,
                                              const RigidBody* rigid_body) {
  if (rigid_body == nullptr) return nullptr;
  const EstimatorParams& params = setup.control.estimation;
  const double dt_s = 1.0 / setup.control.rate_hz;
  const ExternalWrenchKnowledge knowledge = setup.control.external_wrench;
  if (setup.control.estimator == EstimatorKind::kTruth) {
    return std::make_unique<TruthEstimator>(setup.robot, params, knowledge, dt_s, *rigid_body);
  }
  return std::make_unique<LegOdometry>(setup.robot, params, knowledge, dt_s, *rigid_body);
}

std::unique_ptr<wbc::WholeBody> MakeWholeBody(const LocomotionSetup& setup,
                                              const RigidBody* rigid_body) {
  if (setup.control.mode == ControlMode::kPassive || rigid_body == nullptr) return nullptr;
  if (setup.control.mode == ControlMode::kPosition) {
    return std::make_unique<wbc::InverseKinematics>(setup.robot, setup.control.inverse_kinematics,
                                                    1.0 / setup.control.rate_hz);
  }
  return std::make_unique<wbc::InverseDynamics>(setup.robot, setup.control.inverse_dynamics,
                                                *rigid_body);
}

// Does nothing: zero torque, whatever is asked.
void WritePassiveCommand(const ControlTick& tick, ActuatorCommand* command) {
  const Eigen::Index num_joints = tick.state.joint_position.size();
  command->torque_Nm.setZero(num_joints);
  command->centroidal_feet.resize(num_joints == 0 ? tick.feet.size() : 0);
  for (std::size_t i = 0; i < command->centroidal_feet.size(); ++i) {
    command->centroidal_feet[i].p_WF = tick.feet[i].p_WF;
    command->centroidal_feet[i].force_N.setZero(3, tick.feet[i].vertex_force_N.cols());
    command->centroidal_feet[i].in_contact = false;
  }
}

}  // namespace

LocomotionController::LocomotionController(const LocomotionSetup& setup, StageTimer* timer)
    : setup_(setup),
      timer_(timer),
      mpc_period_(TickAt(1.0 / setup.control.mpc.rate_hz, setup.tick_s)),
      rigid_body_(setup.is_centroidal ? nullptr : std::make_unique<RigidBody>(setup.robot)),
      estimator_(MakeEstimator(setup, rigid_body_.get())),
      planner_(MakePlanner(setup, MakeRobotModel(setup, rigid_body_.get()))),
      mpc_(setup.control.mpc, MakeRobotModel(setup, rigid_body_.get()), setup.tick_s),
      whole_body_(MakeWholeBody(setup, rigid_body_.get())) {
  const std::size_t num_feet = setup.robot.feet.size();
  if (setup.is_centroidal) {
    centroidal_estimator_.emplace(static_cast<int>(num_feet), setup.robot.mass_kg,
                                  setup.control.estimation.contact_threshold_N,
                                  setup.control.external_wrench);
  }
  swing_.assign(num_feet, SwingFoot(SwingShape{}, setup.tick_s));
  tick_.feet.resize(num_feet);
  for (std::size_t i = 0; i < num_feet; ++i) {
    tick_.feet[i].vertex_force_N.setZero(3, setup.robot.feet[i].vertices_m.cols());
    tick_.feet[i].planned_contact = true;
  }
  references_.p_WC.setZero(3, setup.control.mpc.knots + 1);
  references_.angular_momentum.setZero(3, setup.control.mpc.knots + 1);
}

const ControlTick& LocomotionController::Update(const SensorFrame& frame) {
  tick_.tick = frame.tick;
  Estimate(frame);
  Plan();
  SolveMpc();
  TargetFeet();
  Command();
  return tick_;
}

void LocomotionController::Command() {
  const ScopedStage stage(timer_, Stage::kWholeBody);
  if (setup_.control.mode == ControlMode::kPassive) {
    WritePassiveCommand(tick_, &tick_.command);
  } else if (rigid_body_ == nullptr) {
    wbc::WriteCentroidalCommand(tick_.feet, &tick_.command);
  } else {
    tick_.wbc =
        whole_body_->Solve(tick_.state, *rigid_body_, tick_.com, tick_.feet, &tick_.command);
  }
}

void LocomotionController::Estimate(const SensorFrame& frame) {
  const ScopedStage stage(timer_, Stage::kEstimator);
  tick_.state = rigid_body_ == nullptr ? centroidal_estimator_->Update(frame)
                                       : estimator_->Update(frame, rigid_body_.get());
}

void LocomotionController::Plan() {
  const ScopedStage stage(timer_, Stage::kPlanner);
  planner_.Update(tick_.state, tick_.tick);
  tick_.reference = planner_.ReferenceAt(tick_.tick);
}

void LocomotionController::SolveMpc() {
  tick_.mpc.ran = false;
  if (setup_.control.mode == ControlMode::kPassive) return;
  if (IsMpcTick()) {
    const ScopedStage stage(timer_, Stage::kMpc);
    SampleReferences();
    mpc_.Solve(tick_.state, planner_.plan(), references_, tick_.tick);
    tick_.mpc = mpc_.report();
  }
  if (mpc_.Activate(tick_.tick)) {
    for (const mpc::Foothold& foothold : mpc_.footholds()) {
      planner_.SetAdjusted(foothold.foot, foothold.index, foothold.p_WF);
    }
    planner_.Update(tick_.state, tick_.tick);
  }
  tick_.mpc_age_s = mpc_.Age_s(tick_.tick);
  if (mpc_.has_plan()) tick_.com = mpc_.ComAt(tick_.tick);
}

// CoM: the planner's. Angular momentum: zero as in the paper, plus what levels a leaning base,
//   h*[k] = I w*,  w* = k theta exp(-k t),  the momentum of an attitude error that decays at rate
//   k.
void LocomotionController::SampleReferences() {
  const mpc::GridReferences& grid = references_;
  const MpcParams& params = setup_.control.mpc;
  const Tick step = TickAt(params.step_s, setup_.tick_s);
  Eigen::Vector3d momentum = Eigen::Vector3d::Zero();
  const double rate = params.attitude_rate_radps;
  if (rigid_body_ != nullptr) {
    momentum = tick_.state.q_WB *
               (rigid_body_->base_inertia() * (rate * UprightError_B(tick_.state.q_WB)));
    momentum.z() = 0.0;
  }
  for (int k = 0; k < grid.p_WC.cols(); ++k) {
    references_.p_WC.col(k) = planner_.ReferenceAt(tick_.tick + k * step).p_WC;
    references_.angular_momentum.col(k) = std::exp(-rate * k * params.step_s) * momentum;
  }
}

void LocomotionController::TargetFeet() {
  const ScopedStage stage(timer_, Stage::kSwing);
  for (std::size_t foot = 0; foot < tick_.feet.size(); ++foot) TargetFoot(foot);
}

void LocomotionController::TargetFoot(std::size_t foot) {
  FootTarget& target = tick_.feet[foot];
  const bool stood = target.planned_contact;
  target.contact = planner_.plan().feet[foot].front();
  target.planned_contact = target.contact.start_tick <= tick_.tick;
  if (mpc_.has_plan() && target.planned_contact) {
    target.vertex_force_N = mpc_.ForceAt(foot, tick_.tick);
  } else {
    target.vertex_force_N.setZero();
  }
  target.force_N = target.vertex_force_N.rowwise().sum();

  SwingFoot& swing = swing_[foot];
  const bool stands = target.planned_contact && tick_.state.feet[foot].in_contact;
  if (stood && !target.planned_contact) {
    const GaitParams& gait = GaitAt(tick_.tick);
    swing.set_shape({gait.swing_height_m, gait.landing_speed_mps});
    swing.LiftOff(tick_.state.feet[foot].p_WF, tick_.tick);
  }
  if (stands || (setup_.is_centroidal && target.planned_contact)) {
    target.p_WF = target.contact.adjusted_p_WF;
    target.v_WF.setZero();
    target.a_WF.setZero();
    return;
  }
  swing.Update(target.contact.adjusted_p_WF, target.contact.start_tick, tick_.tick);
  target.p_WF = swing.position();
  target.v_WF = swing.velocity();
  target.a_WF = swing.acceleration();
}

const GaitParams& LocomotionController::GaitAt(Tick tick) const {
  const GaitParams* gait = &setup_.gait.front();
  for (const GaitParams& segment : setup_.gait) {
    if (TickAt(segment.start_s, setup_.tick_s) <= tick) gait = &segment;
  }
  return *gait;
}

}  // namespace sidestep
