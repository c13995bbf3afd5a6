// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// reference_robot: a robot in a MuJoCo of its own, for what RigidBody does not use.

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <string>

#include "controller/types/robot_state.h"
#include "models/mjcf/mjcf.h"
#include "models/mjcf/quaternion.h"
#include "models/robot_description/robot_description.h"

namespace sidestep {

class ReferenceRobot {
 public:
  explicit ReferenceRobot(const RobotDescription& robot)
      : model_(CompileMjcf("<mujoco><include file=\"robot.xml\"/></mujoco>",
                           RequireModel(robot).drawn_mjcf, robot.model->file)),
        data_(MakeData(*model_)) {}

  const mjModel* model() const { return model_.get(); }
  mjData* data() { return data_.get(); }

  /// Joint of an actuator, by its index.
  int Joint(int actuator) const { return model_->actuator_trnid[2 * actuator]; }

  /// Everything at rest and zero but `state`.
  void Set(const RobotState& state) {
    mj_resetData(model(), data());
    Eigen::Map<Eigen::Vector3d>(data_->qpos) = state.p_WB;
    ToMuJoCo(state.q_WB, data_->qpos + 3);
    Eigen::Map<Eigen::Vector3d>(data_->qvel) = state.v_WB;
    Eigen::Map<Eigen::Vector3d>(data_->qvel + 3) = state.w_WB_B;
    for (int i = 0; i < model_->nu; ++i) {
      data_->qpos[model_->jnt_qposadr[Joint(i)]] = state.joint_position[i];
      data_->qvel[model_->jnt_dofadr[Joint(i)]] = state.joint_velocity[i];
    }
  }

  /// As Set(), with poses of bodies and sites and what Jacobians need.
  void SetPoses(const RobotState& state) {
    Set(state);
    mj_kinematics(model(), data());
    mj_comPos(model(), data());
  }

  /// `state` moved along the velocity `nu` for `time_s`, its velocities as they were.
  RobotState Moved(const RobotState& state, const Eigen::VectorXd& nu, double time_s) {
    Set(state);
    mj_integratePos(model(), data_->qpos, nu.data(), time_s);
    RobotState moved = state;
    moved.p_WB = Eigen::Map<const Eigen::Vector3d>(data_->qpos);
    moved.q_WB = FromMuJoCo(data_->qpos + 3);
    for (int i = 0; i < model_->nu; ++i) {
      moved.joint_position[i] = data_->qpos[model_->jnt_qposadr[Joint(i)]];
    }
    return moved;
  }

  int Site(const std::string& name) const { return RequireId(*model_, mjOBJ_SITE, name); }

  /// Of a site, in W; after SetPoses().
  Eigen::Vector3d Position(const std::string& site) const {
    return Eigen::Map<const Eigen::Vector3d>(data_->site_xpos + 3 * Site(site));
  }
  Eigen::Matrix3d Rotation(const std::string& site) const {
    return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(data_->site_xmat +
                                                                          9 * Site(site));
  }

 private:
  MjModelPtr model_;
  MjDataPtr data_;
};

/// Rotation vector in W of the turn from `from` to `to`, both R_W: for angles below 0.01 rad or so.
inline Eigen::Vector3d SmallTurn_W(const Eigen::Matrix3d& from, const Eigen::Matrix3d& to) {
  const Eigen::Matrix3d turn = to * from.transpose();
  return 0.5 *
         Eigen::Vector3d(turn(2, 1) - turn(1, 2), turn(0, 2) - turn(2, 0), turn(1, 0) - turn(0, 1));
}

}  // namespace sidestep
