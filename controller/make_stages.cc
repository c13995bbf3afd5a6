// SPDX-License-Identifier: BSD-3-Clause
#include "controller/make_stages.h"

#include "controller/estimator/leg_odometry.h"
#include "controller/estimator/truth_estimator.h"
#include "controller/wbc/inverse_dynamics.h"
#include "controller/wbc/inverse_kinematics.h"

namespace sidestep {

mpc::RobotModel PlannedRobot(const RobotDescription& robot, double mass_kg,
                             const Eigen::Vector3d& gravity_mps2) {
  mpc::RobotModel model;
  model.mass_kg = mass_kg;
  model.gravity_mps2 = gravity_mps2;
  for (const FootDescription& foot : robot.feet) {
    model.foot_names.push_back(foot.name);
    model.vertices_m.push_back(foot.vertices_m);
    model.force_shares.push_back(foot.force_shares);
  }
  return model;
}

mpc::RobotModel PlannedRobot(const RobotDescription& robot, const RigidBody& body) {
  mpc::RobotModel model = PlannedRobot(robot, body.mass_kg(), body.gravity_mps2());
  RobotState home;
  home.feet.resize(robot.feet.size());
  body.FillDerived(&home);
  for (std::size_t i = 0; i < robot.feet.size(); ++i) {
    mpc::LegReach& reach = model.legs.emplace_back();
    if (!body.leg(i)) continue;
    const Eigen::Vector3d p_CHip_W = body.leg(i)->p_WHip - home.p_WC;
    const Eigen::Vector3d p_FAnkle_W = body.leg(i)->p_WAnkle - home.feet[i].p_WF;
    reach = {home.feet[i].R_WF.transpose() * (p_CHip_W - p_FAnkle_W), body.leg(i)->length_m};
  }
  return model;
}

std::unique_ptr<StateEstimator> MakeEstimator(const ControllerSetup& setup, const RigidBody& body) {
  const EstimatorParams& params = setup.control.estimation;
  const double dt_s = 1.0 / setup.control.rate_hz;
  const ExternalWrenchKnowledge knowledge = setup.control.external_wrench;
  if (setup.control.estimator == EstimatorKind::kTruth) {
    return std::make_unique<TruthEstimator>(setup.robot, params, knowledge, dt_s, body);
  }
  return std::make_unique<LegOdometry>(setup.robot, params, knowledge, dt_s, body);
}

std::unique_ptr<wbc::WholeBody> MakeWholeBody(const ControllerSetup& setup, const RigidBody& body) {
  if (setup.control.mode == ControlMode::kPosition) {
    return std::make_unique<wbc::InverseKinematics>(setup.robot, setup.control.inverse_kinematics,
                                                    1.0 / setup.control.rate_hz);
  }
  return std::make_unique<wbc::InverseDynamics>(setup.robot, setup.control.inverse_dynamics, body);
}

}  // namespace sidestep
