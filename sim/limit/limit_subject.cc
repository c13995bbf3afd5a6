// SPDX-License-Identifier: BSD-3-Clause
#include "sim/limit/limit_subject.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "controller/model/rigid_body.h"
#include "models/support/config_error.h"
#include "models/support/gravity.h"

namespace sidestep::limit {
namespace {

// Of two soles side by side; vertices lie a little within a sole's edges.
constexpr double kGapOfFeet_m = 0.02;
// What legs of half a metre do with joints of 4 rad/s.
constexpr double kUnknownSpeed_mps = 2.0;

/// Of a foot's vertices along one axis: the middle between both ends, and how far these are from
/// it.
struct Extent {
  double middle_m;
  double half_m;
};

Extent ExtentOf(const FootDescription& foot, int axis) {
  const double least = foot.vertices_m.row(axis).minCoeff();
  const double most = foot.vertices_m.row(axis).maxCoeff();
  return {0.5 * (least + most), 0.5 * (most - least)};
}

/// Of the first foot, the left one of two, for which inwards is -y.
double CopInset(const FootDescription& foot) {
  if (foot.force_shares.size() == 0) return 0.0;
  const double cop_m = foot.vertices_m.row(1).dot(foot.force_shares);
  return std::max(0.0, ExtentOf(foot, 1).middle_m - cop_m);
}

const GaitParams& PushedGaitOf(const Scenario& scenario) {
  const GaitParams* chosen = &scenario.gait.front();
  for (const GaitParams& gait : scenario.gait) {
    const bool counts = scenario.pushes.empty() ? gait.type != GaitType::kStand
                                                : gait.start_s <= scenario.pushes.front().start_s;
    if (counts) chosen = &gait;
  }
  return *chosen;
}

void RefuseWhatHasNoLimit(const Scenario& scenario, const GaitParams& gait) {
  const auto refuse = [&](const std::string& what) {
    const std::string name = scenario.file.empty() ? scenario.robot_name : scenario.file.string();
    throw ConfigError(name + ": error: limit knows walks, stands on two feet and hops, not " +
                      what);
  };
  const bool is_stand = gait.type == GaitType::kStand;
  if (gait.type == GaitType::kRun) refuse("runs");
  if (is_stand && scenario.robot.feet.size() == 1) refuse("a stand on one");
  if (gait.type == GaitType::kWalk && gait.step_side_m != 0.0) refuse("walks sideways");
}

/// How far two feet are apart when both legs are at full length, and their hips.
struct Stride {
  double full_m;
  double hips_m;
};

std::optional<Stride> StrideOf(const Scenario& scenario) {
  const RobotDescription& robot = scenario.robot;
  if (!robot.model) return std::nullopt;
  const RigidBody body(robot);
  const std::optional<StretchedLeg>& leg = body.leg(0);
  if (!leg) return std::nullopt;
  const double length_m = scenario.control.mpc.leg_stretch * leg->length_m;
  const double height_m = leg->p_WHip.z() - leg->p_WAnkle.z();
  const double half_m = std::sqrt(std::max(0.0, length_m * length_m - height_m * height_m));
  const bool has_other = robot.feet.size() == 2 && body.leg(1);
  return Stride{2.0 * half_m,
                has_other ? std::abs(leg->p_WHip.y() - body.leg(1)->p_WHip.y()) : 0.0};
}

void SetReach(const Scenario& scenario, LimitParams* params) {
  const MpcParams& mpc = scenario.control.mpc;
  if (const std::optional<Stride> stride = StrideOf(scenario)) {
    params->reach_m = stride->full_m;
    params->farthest_m = stride->hips_m + stride->full_m;
  } else {
    params->reach_m = std::max(mpc.box_upper_m.x() + params->step_length_m,
                               -mpc.box_lower_m.x() - params->step_length_m);
    params->farthest_m = params->step_width_m + mpc.box_upper_m.y();
  }
  const double least_width_m = scenario.control.planner.min_step_width_m;
  params->nearest_m =
      least_width_m > 0.0 ? least_width_m : 2.0 * params->sole_half_width_m + kGapOfFeet_m;
  params->farthest_m = std::max(params->farthest_m, params->nearest_m);
}

/// A foot that hops stays where friction holds it, below one hip.
void SetReachOfHop(const Scenario& scenario, LimitParams* params) {
  const std::optional<Stride> stride = StrideOf(scenario);
  const double leg_m = stride ? 0.5 * stride->full_m : scenario.control.mpc.box_upper_m.x();
  params->reach_m = std::min(leg_m, scenario.world.friction * scenario.robot.com_height_m);
}

}  // namespace

LimitSubject LimitSubjectOf(const Scenario& scenario) {
  const RobotDescription& robot = scenario.robot;
  const GaitParams& gait = PushedGaitOf(scenario);
  RefuseWhatHasNoLimit(scenario, gait);
  LimitSubject subject;
  subject.gait = gait.type;
  subject.is_planar = robot.base_freedom == BaseFreedom::kSagittal;
  LimitParams& params = subject.params;
  params.omega_per_s = std::sqrt(kGravity_mps2 / robot.com_height_m);
  params.sole_half_length_m = ExtentOf(robot.feet.front(), 0).half_m;
  params.sole_half_width_m = ExtentOf(robot.feet.front(), 1).half_m;
  params.cop_inset_m = CopInset(robot.feet.front());
  params.step_length_m = gait.type == GaitType::kWalk ? gait.step_length_m : 0.0;
  params.step_width_m = gait.step_width_m;
  params.swing_s = gait.swing_s;
  params.double_support_s = gait.double_support_s;
  params.stance_s = gait.stance_s;
  params.flight_s = gait.flight_s;
  const PlannerParams& planner = scenario.control.planner;
  params.swing_speed_mps =
      planner.swing.speed_mps > 0.0 ? planner.swing.speed_mps : kUnknownSpeed_mps;
  params.least_swing_s = planner.timing.least_swing_s;
  params.least_rest_s = planner.timing.least_rest_s;
  params.least_support_s = planner.timing.least_support_s;
  if (gait.type == GaitType::kHop) {
    SetReachOfHop(scenario, &params);
  } else {
    SetReach(scenario, &params);
  }
  return subject;
}

}  // namespace sidestep::limit
