// SPDX-License-Identifier: BSD-3-Clause
#include "sim/world/centroidal_world.h"

#include <algorithm>

#include "models/mjcf/mjcf.h"
#include "models/support/config_error.h"
#include "models/support/gravity.h"
#include "models/support/require.h"

namespace sidestep {
namespace {

constexpr int kFreeJointSize = 7;  // numbers of a free joint in qpos
constexpr char kCom[] = "com";     // as the drawn stand-in and the scenario's pushes call it

double NominalMass(const RobotDescription& robot) {
  if (robot.mass_kg > 0.0) return robot.mass_kg;
  if (!robot.model) {
    throw ConfigError(robot.file.string() + ": error: mass_kg is missing and there is no MJCF");
  }
  const MjModelPtr model = CompileMjcf(robot.model->simulated_mjcf, "", robot.model->file);
  return mj_getTotalmass(model.get());
}

int PushedFoot(const Push& push, const std::vector<FootDescription>& feet,
               const std::string& robot_file) {
  if (push.body == kCom) return -1;
  for (std::size_t i = 0; i < feet.size(); ++i) {
    if (push.body == feet[i].name || push.body == feet[i].frame) return static_cast<int>(i);
  }
  throw ConfigError(robot_file + ": error: the centroidal plant has no body '" + push.body +
                    "' to push: it has " + kCom + " and the feet");
}

// The first foot is the left one, at +y.
double StartSide(std::size_t foot, std::size_t num_feet) {
  if (num_feet == 1) return 0.0;
  return foot == 0 ? 1.0 : -1.0;
}

}  // namespace

Eigen::Vector3d ClampToFrictionCone(const Eigen::Vector3d& force_N, double friction) {
  if (force_N.z() <= 0.0) return Eigen::Vector3d::Zero();
  const double tangential_N = force_N.head<2>().norm();
  const double most_N = friction * force_N.z();
  if (tangential_N <= most_N) return force_N;
  Eigen::Vector3d clipped_N = force_N;
  clipped_N.head<2>() *= most_N / tangential_N;
  return clipped_N;
}

CentroidalState Advance(const CentroidalState& state, const CentroidalLoad& load, double mass_kg,
                        double dt_s) {
  SIDESTEP_REQUIRE(mass_kg > 0.0, mass_kg);
  SIDESTEP_REQUIRE(load.force_N.cols() == load.point_W.cols(), load.point_W.cols());
  const Eigen::Vector3d fixed_N = load.force_N.rowwise().sum();
  Eigen::Vector3d torque_Nm = load.com_torque_Nm;
  for (Eigen::Index i = 0; i < load.force_N.cols(); ++i) {
    torque_Nm += (load.point_W.col(i) - state.p_WC).cross(load.force_N.col(i));
  }
  const Eigen::Vector3d a_WC =
      (fixed_N + load.com_force_N) / mass_kg - kGravity_mps2 * Eigen::Vector3d::UnitZ();

  CentroidalState next;
  next.p_WC = state.p_WC + dt_s * state.v_WC + 0.5 * dt_s * dt_s * a_WC;
  next.v_WC = state.v_WC + dt_s * a_WC;
  // Levers shrink by the CoM's way from the start, whose integral over the tick is this.
  const Eigen::Vector3d way_ms = dt_s * dt_s / 2.0 * state.v_WC + dt_s * dt_s * dt_s / 6.0 * a_WC;
  next.angular_momentum = state.angular_momentum + dt_s * torque_Nm - way_ms.cross(fixed_N);
  return next;
}

CentroidalWorld::CentroidalWorld(const RobotDescription& robot, double start_width_m,
                                 const WorldParams& params, const std::vector<Push>& pushes)
    : robot_file_(robot.file.string()),
      feet_(robot.feet),
      mass_kg_(params.mass_scale * NominalMass(robot)),
      tick_s_(params.step_s),
      friction_(params.friction),
      pushes_(pushes, params.step_s) {
  if (feet_.empty() || feet_.size() > 2) {
    throw ConfigError(robot.file.string() +
                      ": error: the centroidal plant takes a robot of one or two feet");
  }
  ResolvePushes(pushes);
  truth_.feet.resize(feet_.size());
  for (std::size_t i = 0; i < feet_.size(); ++i) {
    truth_.feet[i].p_WF = {0.0, StartSide(i, feet_.size()) * 0.5 * start_width_m,
                           feet_[i].sole_height_m};
    truth_.feet[i].in_contact = true;
    vertex_force_N_.push_back(Eigen::Matrix3Xd::Zero(3, feet_[i].vertices_m.cols()));
  }
  state_.p_WC.z() = robot.com_height_m;
  truth_.qpos.resize(kFreeJointSize * static_cast<Eigen::Index>(1 + feet_.size()));
  WriteTruth();
  UpdatePushes(0);
}

void CentroidalWorld::ResolvePushes(const std::vector<Push>& pushes) {
  pushed_foot_.clear();
  for (const Push& push : pushes) pushed_foot_.push_back(PushedFoot(push, feet_, robot_file_));
}

void CentroidalWorld::ReplacePushes(const std::vector<Push>& pushes, Tick tick) {
  ResolvePushes(pushes);
  pushes_ = Pushes(pushes, tick_s_);
  UpdatePushes(tick);
}

void CentroidalWorld::Apply(const ActuatorCommand& command) {
  const bool has_feet = !command.centroidal_feet.empty();
  SIDESTEP_REQUIRE(!has_feet || command.centroidal_feet.size() == feet_.size(),
                   command.centroidal_feet.size());
  for (std::size_t i = 0; i < feet_.size(); ++i) {
    FootTruth& foot = truth_.feet[i];
    vertex_force_N_[i].setZero();
    if (!has_feet) continue;
    const CentroidalFootCommand& wanted = command.centroidal_feet[i];
    const bool stays = foot.in_contact && wanted.in_contact;
    if (!stays) foot.p_WF = wanted.p_WF;
    foot.in_contact = wanted.in_contact;
    if (!foot.in_contact || wanted.force_N.cols() == 0) continue;
    SIDESTEP_REQUIRE(wanted.force_N.cols() == vertex_force_N_[i].cols(), wanted.force_N.cols());
    for (Eigen::Index vertex = 0; vertex < wanted.force_N.cols(); ++vertex) {
      vertex_force_N_[i].col(vertex) = ClampToFrictionCone(wanted.force_N.col(vertex), friction_);
    }
  }
}

CentroidalLoad CentroidalWorld::CurrentLoad() const {
  Eigen::Index num_forces = static_cast<Eigen::Index>(pushed_foot_.size());
  for (const Eigen::Matrix3Xd& forces : vertex_force_N_) num_forces += forces.cols();
  CentroidalLoad load;
  load.force_N.setZero(3, num_forces);
  load.point_W.setZero(3, num_forces);
  Eigen::Index column = 0;
  for (std::size_t i = 0; i < feet_.size(); ++i) {
    for (Eigen::Index vertex = 0; vertex < vertex_force_N_[i].cols(); ++vertex, ++column) {
      load.force_N.col(column) = vertex_force_N_[i].col(vertex);
      load.point_W.col(column) = truth_.feet[i].p_WF + feet_[i].vertices_m.col(vertex);
    }
  }
  for (std::size_t i = 0; i < pushed_foot_.size(); ++i, ++column) {
    const PushTruth& push = truth_.pushes[i];
    if (pushed_foot_[i] < 0) {  // its point moves with the CoM
      load.com_force_N += push.force_W_N;
      load.com_torque_Nm += (push.p_W - state_.p_WC).cross(push.force_W_N);
    } else {
      load.force_N.col(column) = push.force_W_N;
      load.point_W.col(column) = push.p_W;
    }
  }
  return load;
}

void CentroidalWorld::Step(Tick tick) {
  if (!is_valid()) return;
  UpdatePushes(tick);
  state_ = Advance(state_, CurrentLoad(), mass_kg_, tick_s_);
  for (std::size_t i = 0; i < feet_.size(); ++i) {
    FootTruth& foot = truth_.feet[i];
    foot.f_F_W = vertex_force_N_[i].rowwise().sum();
    foot.m_F_W.setZero();
    for (Eigen::Index vertex = 0; vertex < vertex_force_N_[i].cols(); ++vertex) {
      const Eigen::Vector3d arm = feet_[i].vertices_m.col(vertex);
      foot.m_F_W += arm.cross(vertex_force_N_[i].col(vertex));
    }
    foot.touch_N = std::max(0.0, foot.f_F_W.z());
  }
  if (!state_.p_WC.allFinite() || !state_.v_WC.allFinite() ||
      !state_.angular_momentum.allFinite()) {
    invalid_reason_ = "the centroidal state is not finite";
  }
  WriteTruth();
  UpdatePushes(tick + 1);
}

void CentroidalWorld::UpdatePushes(Tick tick) {
  std::vector<PushedPose> poses;
  for (int foot : pushed_foot_) {
    poses.push_back({foot < 0 ? state_.p_WC : truth_.feet[static_cast<std::size_t>(foot)].p_WF,
                     Eigen::Matrix3d::Identity()});
  }
  truth_.pushes = pushes_.Update(tick, poses, HeadingRad(truth_.q_WB));
}

void CentroidalWorld::WriteTruth() {
  truth_.p_WC = truth_.p_WB = state_.p_WC;
  truth_.v_WC = truth_.v_WB = state_.v_WC;
  truth_.angular_momentum = state_.angular_momentum;
  const auto write_body = [this](std::size_t body, const Eigen::Vector3d& p_W) {
    truth_.qpos.segment<kFreeJointSize>(kFreeJointSize * static_cast<Eigen::Index>(body)) << p_W,
        1.0, 0.0, 0.0, 0.0;
  };
  write_body(0, state_.p_WC);
  for (std::size_t i = 0; i < feet_.size(); ++i) write_body(i + 1, truth_.feet[i].p_WF);
}

}  // namespace sidestep
