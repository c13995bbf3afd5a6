// SPDX-License-Identifier: BSD-3-Clause
#include "controller/motion_chain.h"

#include "controller/mpc/problem/ocp_json.h"
#include "controller/planner/gait_geometry.h"

namespace sidestep {
namespace {

// Feet that are felt decide when they stand; those of the centroidal plant are where they are told.
TouchDownRule TouchDownsOf(const ControllerSetup& setup, const mpc::RobotModel& robot,
                           StandingRule standing) {
  const PlannerParams& params = setup.control.planner;
  TouchDownRule rule;
  rule.is_felt = standing == StandingRule::kWhenFelt;
  rule.early_load_N = params.early_load_ratio * robot.mass_kg * robot.gravity_mps2.norm();
  rule.longest_wait = TickAt(params.late_wait_s, setup.tick_s);
  rule.period = TickAt(1.0 / setup.control.rate_hz, setup.tick_s);
  return rule;
}

FloorSearch SearchOf(const PlannerParams& params) {
  return {params.search_depth_m, params.search_acceleration_mps2};
}

GaitPlanner MakePlanner(const ControllerSetup& setup, const TouchDownRule& touch_downs) {
  GaitGeometry geometry = MakeGaitGeometry(setup.robot, setup.control.planner.sway);
  geometry.box_lower_m = setup.control.mpc.box_lower_m;
  geometry.box_upper_m = setup.control.mpc.box_upper_m;
  const Tick horizon =
      (setup.control.mpc.knots + 1) * TickAt(setup.control.mpc.step_s, setup.tick_s);
  return {{setup.gait, geometry, setup.tick_s}, setup.control.planner, horizon, touch_downs};
}

std::optional<dcm::DcmPlan> MakeDcmPlan(const ControllerSetup& setup,
                                        const mpc::RobotModel& robot) {
  if (setup.control.stepping == Stepping::kMpc) return std::nullopt;
  return dcm::DcmPlan(
      {setup.control, setup.robot.com_height_m, robot.mass_kg, robot.vertices_m, setup.tick_s});
}

std::vector<FootTarget> StandingFeet(const RobotDescription& robot) {
  std::vector<FootTarget> feet(robot.feet.size());
  for (std::size_t i = 0; i < feet.size(); ++i) {
    feet[i].planned_contact = true;
    feet[i].vertex_force_N.setZero(3, robot.feet[i].vertices_m.cols());
  }
  return feet;
}

}  // namespace

MotionChain::MotionChain(const ControllerSetup& setup, const mpc::RobotModel& robot,
                         StandingRule rule)
    : params_(setup.control.mpc),
      tick_s_(setup.tick_s),
      mpc_period_(TickAt(1.0 / params_.rate_hz, tick_s_)),
      planner_(MakePlanner(setup, TouchDownsOf(setup, robot, rule))),
      mpc_(params_, robot, tick_s_),
      dcm_(MakeDcmPlan(setup, robot)),
      timing_(setup.control.planner.timing, params_, setup.robot.com_height_m, robot.mass_kg,
              tick_s_),
      foot_targets_(setup.robot.feet.size(), rule, tick_s_, SearchOf(setup.control.planner),
                    setup.control.planner.swing),
      feet_(StandingFeet(setup.robot)) {}

const ContactPlan& MotionChain::Schedule(const RobotState& state, Tick tick, StageTimer* timer) {
  const ScopedStage stage(timer, Stage::kPlanner);
  return planner_.Update(state, tick);
}

const ComTarget& MotionChain::Plan(const RobotState& state, const Eigen::Vector3d& momentum,
                                   Tick tick, StageTimer* timer) {
  report_.ran = false;
  if (dcm_) {
    PlanByDcm(state, momentum, tick, timer);
  } else {
    PlanByMpc(state, momentum, tick, timer);
  }
  return com_;
}

void MotionChain::PlanByDcm(const RobotState& state, const Eigen::Vector3d& momentum, Tick tick,
                            StageTimer* timer) {
  const ScopedStage stage(timer, Stage::kMpc);
  if (SolvesAt(tick)) momentum_ = momentum;
  dcm_->Update(state, momentum_, tick, &planner_);
  com_ = dcm_->com();
}

void MotionChain::PlanByMpc(const RobotState& state, const Eigen::Vector3d& momentum, Tick tick,
                            StageTimer* timer) {
  if (SolvesAt(tick)) {
    const ScopedStage stage(timer, Stage::kMpc);
    const auto course = timing_.Choose(state, planner_, momentum, tick, &mpc_);
    if (course) planner_.Adopt(*course);
    SampleReferences(planner_.schedule(), mpc_.GridAt(planner_.plan(), tick), momentum, params_,
                     tick_s_, &references_);
    mpc_.Solve(state, planner_.plan(), references_, tick);
    report_ = mpc_.report();
  }
  if (mpc_.Activate(tick)) {  // the chain's one arrow back: what was planned is where feet will go
    planner_.AdoptFootholds(mpc_.footholds());
  }
  if (mpc_.has_plan()) {
    com_ = mpc_.ComAt(tick);
  } else {
    const ComReference nominal = planner_.ReferenceAt(tick);
    com_.p_WC = nominal.p_WC;
    com_.v_WC = nominal.v_WC;
    com_.a_WC = nominal.a_WC;
  }
}

const std::vector<FootTarget>& MotionChain::TargetFeet(const RobotState& state, Tick tick,
                                                       StageTimer* timer) {
  const ScopedStage stage(timer, Stage::kSwing);
  foot_targets_.Update(state, planner_.plan(), tick, &feet_);
  for (std::size_t i = 0; i < feet_.size(); ++i) {
    FootTarget& foot = feet_[i];
    if (dcm_ && foot.planned_contact) {
      foot.vertex_force_N = dcm_->ForceOn(i);
    } else if (mpc_.has_plan() && foot.planned_contact) {
      foot.vertex_force_N = mpc_.ForceAt(i, tick);
    } else {
      foot.vertex_force_N.setZero();
    }
    foot.force_N = foot.vertex_force_N.rowwise().sum();
  }
  return feet_;
}

void MotionChain::WriteTo(ControlTick* tick) const {
  tick->reference = planner_.ReferenceAt(tick->tick);
  tick->com = com_;
  tick->feet = feet_;
  tick->mpc = report_;
  if (dcm_) tick->step.status = dcm_->qp_status();
  tick->mpc_age_s = mpc_.Age_s(tick->tick);
}

std::string MotionChain::LastProblemJson(const std::string& name) const {
  if (dcm_) return {};
  nlohmann::json problem = mpc::ToJson(mpc_.problem());
  problem["name"] = name;
  problem["solver"] = mpc::SolverSetupToJson(mpc_.problem(), mpc_.solver_setup());
  return problem.dump(1) + "\n";
}

}  // namespace sidestep
