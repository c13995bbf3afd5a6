// SPDX-License-Identifier: BSD-3-Clause
// Names and sizes, and what Update() evaluates at once; the rest is in rigid_body_evaluate.cc.
#include "controller/model/rigid_body.h"

#include <limits>

#include "models/mjcf/leg_root.h"
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

BaseMotion BaseOf(const RobotState& state) {
  return {state.p_WB, state.q_WB, state.v_WB, state.w_WB_B};
}

void SetBase(const BaseMotion& base, RobotState* state) {
  state->p_WB = base.p_WB;
  state->q_WB = base.q_WB;
  state->v_WB = base.v_WB;
  state->w_WB_B = base.w_WB_B;
}

}  // namespace

RigidBody::RigidBody(const RobotDescription& robot)
    : state_(CompileMjcf(kBareWorld, RequireModel(robot).simulated_mjcf, robot.model->file)),
      mass_kg_(mj_getTotalmass(&state_.model())),
      gravity_mps2_(Eigen::Map<const Eigen::Vector3d>(state_.model().opt.gravity)),
      base_body_(RequireId(state_.model(), mjOBJ_BODY, robot.base)),
      base_(state_.model(), base_body_, robot.model->file.string()) {
  ResolveNames(robot);
  TakeMemory();
  PlaceAtHome(state_.model(), robot, state_.get());
  home_position_ = Eigen::Map<const Eigen::VectorXd>(state_->qpos, state_.model().nq);
  RobotState home;
  WriteHome(&home);
  Update(home);
  for (std::size_t foot = 0; foot < num_feet(); ++foot) {
    const bool is_sole = robot.feet[foot].vertices_m.cols() > 1;
    legs_.push_back(FindStretchedLeg(state_, leg_root_body_, foot_site_[foot], is_sole));
  }
}

void RigidBody::ResolveNames(const RobotDescription& robot) {
  const mjModel& model = state_.model();
  SIDESTEP_REQUIRE(model.body_jntadr[base_body_] == 0, robot.base);  // nu begins with the base
  for (const FootDescription& foot : robot.feet) {
    foot_site_.push_back(RequireId(model, mjOBJ_SITE, foot.frame));
  }
  leg_root_body_ = RootOfLegs(model, foot_site_, base_body_);
  imu_site_ = RequireId(model, mjOBJ_SITE, robot.imu);
  ResolveImuChain();
  if (!robot.torso.empty()) torso_site_ = RequireId(model, mjOBJ_SITE, robot.torso);
  for (const std::string& name : robot.force_torque) {
    const auto address = [&](const char* suffix) {
      return model.sensor_adr[RequireId(model, mjOBJ_SENSOR, name + suffix)];
    };
    force_torque_ids_.push_back(
        {RequireId(model, mjOBJ_SITE, name), address("_force"), address("_torque")});
  }
  ResolveActuators();
}

void RigidBody::ResolveActuators() {
  const mjModel& model = state_.model();
  torque_limit_Nm_.setZero(model.nu);
  joint_lower_.setConstant(model.nu, -std::numeric_limits<double>::infinity());
  joint_upper_.setConstant(model.nu, std::numeric_limits<double>::infinity());
  for (int actuator = 0; actuator < model.nu; ++actuator) {
    SIDESTEP_REQUIRE(model.actuator_trntype[actuator] == mjTRN_JOINT, actuator);
    const int joint = model.actuator_trnid[2 * actuator];
    actuated_position_.push_back(model.jnt_qposadr[joint]);
    actuated_velocity_.push_back(model.jnt_dofadr[joint]);
    torque_limit_Nm_[actuator] = model.actuator_ctrlrange[2 * actuator + 1];
    if (model.jnt_limited[joint] != 0) {
      joint_lower_[actuator] = model.jnt_range[2 * joint];
      joint_upper_[actuator] = model.jnt_range[2 * joint + 1];
    }
  }
}

// Hinges between base and IMU.
void RigidBody::ResolveImuChain() {
  const mjModel& model = state_.model();
  int body = model.site_bodyid[imu_site_];
  for (; body != base_body_ && body != 0; body = model.body_parentid[body]) {
    for (int i = 0; i < model.body_jntnum[body]; ++i) {
      const int joint = model.body_jntadr[body] + i;
      if (model.jnt_type[joint] == mjJNT_HINGE) joints_to_imu_.push_back(joint);
    }
  }
}

void RigidBody::TakeMemory() {
  const int nv = num_velocities();
  velocity_.setZero(nv);
  feet_.resize(num_feet());
  force_torque_.resize(force_torque_ids_.size());
  evaluated_.mass_matrix.setZero(nv, nv);
  evaluated_.com_jacobian.setZero(3, nv);
  evaluated_.bias.setZero(nv);
  const Jacobian3 none = Jacobian3::Zero(3, nv);
  evaluated_.foot_jacobian.assign(num_feet(), {none, none});
  evaluated_.foot_bias.resize(num_feet());
  evaluated_.torso_jacobian = none;
  evaluated_.angular_momentum_jacobian = none;
}

void RigidBody::SetState(const RobotState& state) {
  mjData* data = state_.get();
  base_.Write(BaseOf(state), data);
  SetJoints(state);
  velocity_ = Eigen::Map<const Eigen::VectorXd>(data->qvel, num_velocities());
}

void RigidBody::SetJoints(const RobotState& state) {
  for (std::size_t i = 0; i < actuated_position_.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(i);
    state_->qpos[actuated_position_[i]] = state.joint_position[at];
    state_->qvel[actuated_velocity_[i]] = state.joint_velocity[at];
  }
}

void RigidBody::Update(const RobotState& state) {
  const mjModel* model = &state_.model();
  mjData* data = state_.get();
  SetState(state);
  mj_kinematics(model, data);
  mj_comPos(model, data);
  mj_comVel(model, data);
  centroidal_ = CentroidalMotionOf(*model, *data, base_body_);
  base_.Project(&centroidal_);
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
  if (has_torso()) {
    torso_.R_WT = ConstMatrix3Map(data->site_xmat + 9 * torso_site_);
    mj_objectVelocity(model, data, mjOBJ_SITE, torso_site_, twist, 0);
    torso_.w_WT = ConstVector3Map(twist);
  }
  has_state_ = true;
  evaluated_.has_mass_matrix = evaluated_.has_bias = evaluated_.has_frame_jacobians =
      evaluated_.has_frame_bias = evaluated_.has_angular_momentum = false;
}

Eigen::Matrix3d RigidBody::leg_root_R_W() const {
  RequireState();
  return ConstMatrix3Map(state_->xmat + 9 * leg_root_body_);
}

void RigidBody::Translate(const Eigen::Vector3d& p, const Eigen::Vector3d& v) {
  RequireState();
  SIDESTEP_REQUIRE(!base_.is_sagittal() || (p.y() == 0.0 && v.y() == 0.0), "out of the plane");
  BaseMotion base = base_.Read(*state_.get());
  base.p_WB += p;
  base.v_WB += v;
  base_.Write(base, state_.get());
  velocity_ = Eigen::Map<const Eigen::VectorXd>(state_->qvel, num_velocities());
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
  mjData* data = state_.get();
  has_state_ = false;
  base_.Write(BaseMotion{}, data);
  SetJoints(state);
  mj_kinematics(&state_.model(), data);
  ImuInBase imu{ConstMatrix3Map(data->site_xmat + 9 * imu_site_), Eigen::Vector3d::Zero()};
  for (const int joint : joints_to_imu_) {
    imu.w_BU_B +=
        data->qvel[state_.model().jnt_dofadr[joint]] * ConstVector3Map(data->xaxis + 3 * joint);
  }
  return imu;
}

const std::vector<ForceTorqueKinematics>& RigidBody::PredictForceTorque(
    const Eigen::VectorXd& nudot) {
  RequireState();
  mjData* data = state_.get();
  Eigen::Map<Eigen::VectorXd>(data->qacc, num_velocities()) = nudot;
  mj_sensorAcc(&state_.model(), data);
  for (std::size_t i = 0; i < force_torque_.size(); ++i) {
    const ForceTorqueIds& ids = force_torque_ids_[i];
    force_torque_[i].p_WS = ConstVector3Map(data->site_xpos + 3 * ids.site);
    force_torque_[i].R_WS = ConstMatrix3Map(data->site_xmat + 9 * ids.site);
    force_torque_[i].unloaded.force_N =
        kDistalOnProximal * ConstVector3Map(data->sensordata + ids.force);
    force_torque_[i].unloaded.torque_Nm =
        kDistalOnProximal * ConstVector3Map(data->sensordata + ids.torque);
  }
  return force_torque_;
}

void RigidBody::WriteHome(RobotState* state) const {
  const Eigen::VectorXd at_rest = Eigen::VectorXd::Zero(num_velocities());
  SetBase(base_.Read(home_position_.data(), at_rest.data()), state);
  state->joint_position.setZero(num_actuators());
  state->joint_velocity.setZero(num_actuators());
  for (std::size_t i = 0; i < actuated_position_.size(); ++i) {
    state->joint_position[static_cast<Eigen::Index>(i)] = home_position_[actuated_position_[i]];
  }
}

void RigidBody::Project(RobotState* state) const {
  BaseMotion base = BaseOf(*state);
  base_.Project(&base);
  SetBase(base, state);
  base_.ProjectWrench(&state->external_wrench.force_N, &state->external_wrench.torque_Nm);
}

void RigidBody::FillDerived(RobotState* state) const {
  RequireState();
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

void RigidBody::RequireState() const {
  SIDESTEP_REQUIRE(has_state_, "the rigid body is at no state: LocateImu() moved it");
}

}  // namespace sidestep
