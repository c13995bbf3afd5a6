// SPDX-License-Identifier: BSD-3-Clause
#include "controller/model/rigid_body.h"

#include <limits>

#include "models/mjcf/quaternion.h"
#include "models/robot_description/home_pose.h"
#include "models/support/require.h"

namespace sidestep {
namespace {

using ConstVector3Map = Eigen::Map<const Eigen::Vector3d>;
using ConstMatrix3Map = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>;

// MuJoCo's force and torque sensors tell what the parent does to the child; we tell the opposite.
constexpr double kDistalOnProximal = -1.0;

// World around the robot for the controller: nothing but gravity.
constexpr char kBareWorld[] = "<mujoco model=\"nominal\"><include file=\"robot.xml\"/></mujoco>";

}  // namespace

RigidBody::RigidBody(const RobotDescription& robot)
    : model_(CompileMjcf(kBareWorld, RequireModel(robot).simulated_mjcf, robot.model->file)),
      data_(MakeData(*model_)),
      gravity_mps2_(Eigen::Map<const Eigen::Vector3d>(model_->opt.gravity)) {
  ResolveNames(robot);
  const int nv = model_->nv;
  mass_matrix_.setZero(nv, nv);
  bias_.setZero(nv);
  velocity_.setZero(nv);
  com_jacobian_.setZero(3, nv);
  feet_.resize(robot.feet.size());
  for (FootKinematics& foot : feet_) {
    foot.J.setZero(3, nv);
    foot.J_rot.setZero(3, nv);
  }
  torso_.J_rot.setZero(3, nv);
  PlaceAtHome(*model_, robot, data_.get());
  home_position_ = Eigen::Map<const Eigen::VectorXd>(data_->qpos, model_->nq);
  mass_kg_ = mj_getTotalmass(model_.get());
}

void RigidBody::ResolveNames(const RobotDescription& robot) {
  base_body_ = RequireId(*model_, mjOBJ_BODY, robot.base);
  const int root = model_->body_jntadr[base_body_];
  SIDESTEP_REQUIRE(root == 0 && model_->jnt_type[0] == mjJNT_FREE, robot.base);
  for (const FootDescription& foot : robot.feet) {
    foot_site_.push_back(RequireId(*model_, mjOBJ_SITE, foot.frame));
  }
  imu_site_ = RequireId(*model_, mjOBJ_SITE, robot.imu);
  ResolveImuChain();
  if (!robot.torso.empty()) torso_site_ = RequireId(*model_, mjOBJ_SITE, robot.torso);
  for (const std::string& name : robot.force_torque) {
    const auto address = [&](const char* suffix) {
      return model_->sensor_adr[RequireId(*model_, mjOBJ_SENSOR, name + suffix)];
    };
    force_torque_ids_.push_back(
        {RequireId(*model_, mjOBJ_SITE, name), address("_force"), address("_torque")});
  }
  force_torque_.resize(force_torque_ids_.size());
  torque_limit_Nm_.setZero(model_->nu);
  joint_lower_.setConstant(model_->nu, -std::numeric_limits<double>::infinity());
  joint_upper_.setConstant(model_->nu, std::numeric_limits<double>::infinity());
  for (int actuator = 0; actuator < model_->nu; ++actuator) {
    SIDESTEP_REQUIRE(model_->actuator_trntype[actuator] == mjTRN_JOINT, actuator);
    const int joint = model_->actuator_trnid[2 * actuator];
    actuated_position_.push_back(model_->jnt_qposadr[joint]);
    actuated_velocity_.push_back(model_->jnt_dofadr[joint]);
    torque_limit_Nm_[actuator] = model_->actuator_ctrlrange[2 * actuator + 1];
    if (model_->jnt_limited[joint] != 0) {
      joint_lower_[actuator] = model_->jnt_range[2 * joint];
      joint_upper_[actuator] = model_->jnt_range[2 * joint + 1];
    }
  }
}

// Hinges between base and IMU.
void RigidBody::ResolveImuChain() {
  int body = model_->site_bodyid[imu_site_];
  for (; body != base_body_ && body != 0; body = model_->body_parentid[body]) {
    for (int i = 0; i < model_->body_jntnum[body]; ++i) {
      const int joint = model_->body_jntadr[body] + i;
      if (model_->jnt_type[joint] == mjJNT_HINGE) joints_to_imu_.push_back(joint);
    }
  }
}

void RigidBody::SetState(const RobotState& state) {
  Eigen::Map<Eigen::Vector3d>(data_->qpos) = state.p_WB;
  ToMuJoCo(state.q_WB, data_->qpos + 3);
  Eigen::Map<Eigen::Vector3d>(data_->qvel) = state.v_WB;
  Eigen::Map<Eigen::Vector3d>(data_->qvel + 3) = state.w_WB_B;
  SetJoints(state);
  velocity_ = Eigen::Map<const Eigen::VectorXd>(data_->qvel, model_->nv);
}

void RigidBody::SetJoints(const RobotState& state) {
  for (std::size_t i = 0; i < actuated_position_.size(); ++i) {
    data_->qpos[actuated_position_[i]] = state.joint_position[static_cast<Eigen::Index>(i)];
    data_->qvel[actuated_velocity_[i]] = state.joint_velocity[static_cast<Eigen::Index>(i)];
  }
}

void RigidBody::Update(const RobotState& state) {
  UpdateKinematics(state);
  UpdateJacobians();
  UpdateBias();
  UpdateFootBias();
}

void RigidBody::UpdateKinematics(const RobotState& state) {
  const mjModel* model = model_.get();
  mjData* data = data_.get();
  SetState(state);
  mj_kinematics(model, data);
  mj_comPos(model, data);
  mj_comVel(model, data);
  centroidal_ = CentroidalMotionOf(*model, *data, base_body_);
  mjtNum twist[6];  // [angular; linear]
  for (std::size_t i = 0; i < feet_.size(); ++i) {
    FootKinematics& foot = feet_[i];
    foot.p_WF = ConstVector3Map(data->site_xpos + 3 * foot_site_[i]);
    foot.R_WF = ConstMatrix3Map(data->site_xmat + 9 * foot_site_[i]);
    mj_objectVelocity(model, data, mjOBJ_SITE, foot_site_[i], twist, 0);
    foot.w_WF = ConstVector3Map(twist);
    foot.v_WF = ConstVector3Map(twist + 3);
  }
  imu_.p_WU = ConstVector3Map(data->site_xpos + 3 * imu_site_);
  imu_.R_WU = ConstMatrix3Map(data->site_xmat + 9 * imu_site_);
  mj_objectVelocity(model, data, mjOBJ_SITE, imu_site_, twist, 0);
  imu_.w_WU = ConstVector3Map(twist);
  imu_.v_WU = ConstVector3Map(twist + 3);
  if (has_torso()) torso_.R_WT = ConstMatrix3Map(data->site_xmat + 9 * torso_site_);
}

void RigidBody::Translate(const Eigen::Vector3d& p, const Eigen::Vector3d& v) {
  Eigen::Map<Eigen::Vector3d>(data_->qpos) += p;
  Eigen::Map<Eigen::Vector3d>(data_->qvel) += v;
  velocity_.head<3>() += v;
  centroidal_.p_WC += p;
  centroidal_.v_WC += v;
  for (FootKinematics& foot : feet_) {
    foot.p_WF += p;
    foot.v_WF += v;
  }
  imu_.p_WU += p;
  imu_.v_WU += v;
}

ImuInBase RigidBody::LocateImu(const RobotState& state) {
  mju_zero3(data_->qpos);
  mju_unit4(data_->qpos + 3);
  SetJoints(state);
  mj_kinematics(model_.get(), data_.get());
  ImuInBase imu{ConstMatrix3Map(data_->site_xmat + 9 * imu_site_), Eigen::Vector3d::Zero()};
  for (const int joint : joints_to_imu_) {
    imu.w_BU_B +=
        data_->qvel[model_->jnt_dofadr[joint]] * ConstVector3Map(data_->xaxis + 3 * joint);
  }
  return imu;
}

void RigidBody::UpdateJacobians() {
  const mjModel* model = model_.get();
  mjData* data = data_.get();
  mj_crb(model, data);
  mj_fullM(model, mass_matrix_.data(), data->qM);
  // The base's linear rows are Newton's law of the whole robot: m a_C - m g = sum of forces.
  com_jacobian_ = mass_matrix_.topRows<3>() / mass_kg_;
  for (std::size_t i = 0; i < feet_.size(); ++i) {
    mj_jacSite(model, data, feet_[i].J.data(), feet_[i].J_rot.data(), foot_site_[i]);
  }
  if (has_torso()) mj_jacSite(model, data, nullptr, torso_.J_rot.data(), torso_site_);
}

void RigidBody::UpdateBias() {
  const mjModel* model = model_.get();
  mjData* data = data_.get();
  mj_passive(model, data);
  mj_rne(model, data, 0, data->qfrc_bias);
  bias_ = Eigen::Map<const Eigen::VectorXd>(data->qfrc_bias, model->nv) -
          Eigen::Map<const Eigen::VectorXd>(data->qfrc_passive, model->nv);
  com_bias_mps2_ = bias_.head<3>() / mass_kg_ + gravity_mps2_;
}

void RigidBody::UpdateFootBias() {
  const mjModel* model = model_.get();
  mjData* data = data_.get();
  // With qacc = 0 an object's acceleration is Jdot nu, minus gravity by MuJoCo's convention.
  mju_zero(data->qacc, model->nv);
  mj_rnePostConstraint(model, data);
  for (std::size_t i = 0; i < feet_.size(); ++i) {
    mjtNum acceleration[6];  // [angular; linear]
    mj_objectAcceleration(model, data, mjOBJ_SITE, foot_site_[i], acceleration, 0);
    feet_[i].bias_mps2 = ConstVector3Map(acceleration + 3) + gravity_mps2_;
  }
}

void RigidBody::UpdateForceTorque(const Eigen::VectorXd& nudot) {
  Eigen::Map<Eigen::VectorXd>(data_->qacc, model_->nv) = nudot;
  mj_sensorAcc(model_.get(), data_.get());
  for (std::size_t i = 0; i < force_torque_.size(); ++i) {
    const ForceTorqueIds& ids = force_torque_ids_[i];
    force_torque_[i].p_WS = ConstVector3Map(data_->site_xpos + 3 * ids.site);
    force_torque_[i].R_WS = ConstMatrix3Map(data_->site_xmat + 9 * ids.site);
    force_torque_[i].unloaded.force_N =
        kDistalOnProximal * ConstVector3Map(data_->sensordata + ids.force);
    force_torque_[i].unloaded.torque_Nm =
        kDistalOnProximal * ConstVector3Map(data_->sensordata + ids.torque);
  }
}

void RigidBody::WriteHome(RobotState* state) const {
  state->p_WB = home_position_.head<3>();
  state->q_WB = FromMuJoCo(home_position_.data() + 3);
  state->v_WB.setZero();
  state->w_WB_B.setZero();
  state->joint_position.setZero(model_->nu);
  state->joint_velocity.setZero(model_->nu);
  for (std::size_t i = 0; i < actuated_position_.size(); ++i) {
    state->joint_position[static_cast<Eigen::Index>(i)] = home_position_[actuated_position_[i]];
  }
}

void RigidBody::FillDerived(RobotState* state) const {
  state->p_WC = centroidal_.p_WC;
  state->v_WC = centroidal_.v_WC;
  state->angular_momentum = centroidal_.angular_momentum;
  for (std::size_t i = 0; i < feet_.size(); ++i) {
    state->feet[i].p_WF = feet_[i].p_WF;
    state->feet[i].R_WF = feet_[i].R_WF;
    state->feet[i].v_WF = feet_[i].v_WF;
    state->feet[i].w_WF = feet_[i].w_WF;
  }
}

}  // namespace sidestep
