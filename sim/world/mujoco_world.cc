// SPDX-License-Identifier: BSD-3-Clause
#include "sim/world/mujoco_world.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "models/mjcf/centroidal_motion.h"
#include "models/mjcf/mjcf.h"
#include "models/mjcf/quaternion.h"
#include "models/robot_description/home_pose.h"
#include "models/support/config_error.h"
#include "sim/world/world_model.h"

namespace sidestep {
namespace {

using ConstVector3Map = Eigen::Map<const Eigen::Vector3d>;
using ConstMatrix3Map = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>;

constexpr int kWorldBody = 0;
// No foot of a robot at home is deeper in the ground than it stands (0.2 mm, measured).
constexpr double kDeepestStart_m = 0.005;

// Least and greatest torque of each motor (N for a slide).
Eigen::MatrixX2d MotorRanges(const mjModel& model) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Eigen::MatrixX2d range_Nm(model.nu, 2);
  for (int motor = 0; motor < model.nu; ++motor) {
    range_Nm.row(motor) << -kInfinity, kInfinity;
    if (model.actuator_ctrllimited[motor] == 0) continue;
    range_Nm.row(motor) << model.actuator_ctrlrange[2 * motor],
        model.actuator_ctrlrange[2 * motor + 1];
  }
  return range_Nm;
}

}  // namespace

MujocoWorld::MujocoWorld(const RobotDescription& robot, const WorldParams& params,
                         const std::vector<Push>& pushes)
    : model_(CompileRobotWorld(robot, params, ModelDetail::kSimulated)),
      data_(model_),
      pushes_(pushes, params.step_s),
      mass_kg_(mj_getTotalmass(model_.get())),
      base_body_(RequireId(*model_, mjOBJ_BODY, robot.base)),
      base_(*model_, base_body_, robot.model->file.string()),
      servos_(robot.joints, MotorRanges(*model_)),
      is_uneven_(!params.ground.empty()) {
  ResolveNames(robot);
  ResolvePushes(pushes);
  PlaceAtHome(*model_, robot, data_.get());
  mj_forward(model_.get(), data_.get());
  mj_step1(model_.get(), data_.get());
  ReadState();
  UpdatePushes(0);
  if (is_uneven_) CheckStart(robot);
}

// Patches of the ground may stand in the robot's way, but not in the robot.
void MujocoWorld::CheckStart(const RobotDescription& robot) const {
  for (int i = 0; i < data_->ncon; ++i) {
    const mjContact& contact = data_->contact[i];
    const int body1 = model_->geom_bodyid[contact.geom1];
    const int body2 = model_->geom_bodyid[contact.geom2];
    if (body1 != kWorldBody && body2 != kWorldBody) continue;
    const int body = body1 == kWorldBody ? body2 : body1;
    const bool is_foot = std::any_of(feet_.begin(), feet_.end(), [&](const Foot& foot) {
      return model_->body_weldid[body] == foot.weld;
    });
    if (contact.dist > (is_foot ? -kDeepestStart_m : 0.0)) continue;
    const char* name = mj_id2name(model_.get(), mjOBJ_BODY, body);
    throw ConfigError("world.ground: error: a patch lies where '" + robot.name +
                      "' starts: body '" + (name != nullptr ? name : "") + "' is in the ground");
  }
}

int MujocoWorld::SensorAddress(const std::string& name) const {
  return model_->sensor_adr[RequireId(*model_, mjOBJ_SENSOR, name)];
}

void MujocoWorld::ResolveNames(const RobotDescription& robot) {
  imu_ = {SensorAddress(robot.imu + "_orientation"), SensorAddress(robot.imu + "_gyro"),
          SensorAddress(robot.imu + "_accelerometer")};
  for (const std::string& name : robot.force_torque) {
    force_torque_.push_back({SensorAddress(name + "_force"), SensorAddress(name + "_torque")});
  }
  truth_.force_torque.resize(force_torque_.size());
  ResolveFeet(robot);
  ResolveJoints(robot);
}

void MujocoWorld::ResolveFeet(const RobotDescription& robot) {
  for (const FootDescription& description : robot.feet) {
    Foot foot;
    foot.site = RequireId(*model_, mjOBJ_SITE, description.frame);
    foot.weld = model_->body_weldid[model_->site_bodyid[foot.site]];
    if (description.force_torque.empty()) foot.touch = SensorAddress(description.name + "_touch");
    feet_.push_back(foot);
  }
  truth_.feet.resize(feet_.size());
}

void MujocoWorld::ResolveJoints(const RobotDescription& robot) {
  for (int motor = 0; motor < model_->nu; ++motor) {
    const int joint = model_->actuator_trnid[2 * motor];
    joint_.push_back(joint);
    JointInfo info;
    info.name = mj_id2name(model_.get(), mjOBJ_JOINT, joint);
    info.is_slide = model_->jnt_type[joint] == mjJNT_SLIDE;
    if (model_->jnt_limited[joint] != 0) {
      info.position_min = model_->jnt_range[2 * joint];
      info.position_max = model_->jnt_range[2 * joint + 1];
    }
    if (model_->actuator_ctrllimited[motor] != 0) {
      const mjtNum* range = model_->actuator_ctrlrange + 2 * motor;
      info.torque_limit_Nm = std::max(std::abs(range[0]), std::abs(range[1]));
    }
    joints_.push_back(info);
    const auto at = static_cast<std::size_t>(motor);
    if (!robot.joints.empty() && robot.joints[at].name != info.name) {
      throw ConfigError(robot.file.string() + ": error: servo " + std::to_string(motor) +
                        " is called '" + robot.joints[at].name + "', but the MJCF's motor moves '" +
                        info.name + "'");
    }
  }
  truth_.joint_position.setZero(model_->nu);
  truth_.joint_velocity.setZero(model_->nu);
  truth_.joint_torque_Nm.setZero(model_->nu);
}

void MujocoWorld::ResolvePushes(const std::vector<Push>& pushes) {
  pushed_.clear();
  for (const Push& push : pushes) {
    PushedObject object;
    object.site = mj_name2id(model_.get(), mjOBJ_SITE, push.body.c_str());
    object.body = object.site >= 0 ? model_->site_bodyid[object.site]
                                   : RequireId(*model_, mjOBJ_BODY, push.body);
    pushed_.push_back(object);
  }
  pushed_poses_.resize(pushed_.size());
}

void MujocoWorld::ReplacePushes(const std::vector<Push>& pushes, Tick tick) {
  ResolvePushes(pushes);
  pushes_ = Pushes(pushes, model_->opt.timestep);
  UpdatePushes(tick);
}

void MujocoWorld::Apply(const ActuatorCommand& command) { servos_.Apply(command); }

void MujocoWorld::Step(Tick tick) {
  ApplyPushes();
  servos_.Update(truth_.joint_position, truth_.joint_velocity);
  Eigen::Map<Eigen::VectorXd>(data_->ctrl, model_->nu) = servos_.torque_Nm();
  mj_step2(model_.get(), data_.get());
  ReadContacts();
  mj_step1(model_.get(), data_.get());
  ReadState();
  UpdatePushes(tick + 1);
  CheckValid();
}

void MujocoWorld::UpdatePushes(Tick tick) {
  for (std::size_t i = 0; i < pushed_.size(); ++i) {
    const PushedObject& object = pushed_[i];
    const bool is_site = object.site >= 0;
    pushed_poses_[i].p_WO = ConstVector3Map(is_site ? data_->site_xpos + 3 * object.site
                                                    : data_->xpos + 3 * object.body);
    pushed_poses_[i].R_WO = ConstMatrix3Map(is_site ? data_->site_xmat + 9 * object.site
                                                    : data_->xmat + 9 * object.body);
  }
  truth_.pushes = pushes_.Update(tick, pushed_poses_, HeadingRad(truth_.q_WB));
}

// xfrc_applied is [force; torque] at the body's CoM and persists: written whole at every step.
void MujocoWorld::ApplyPushes() {
  mju_zero(data_->xfrc_applied, 6 * model_->nbody);
  for (std::size_t i = 0; i < pushed_.size(); ++i) {
    const PushTruth& push = truth_.pushes[i];
    const int body = pushed_[i].body;
    const Eigen::Vector3d arm = push.p_W - ConstVector3Map(data_->xipos + 3 * body);
    Eigen::Map<Eigen::Vector3d>(data_->xfrc_applied + 6 * body) += push.force_W_N;
    Eigen::Map<Eigen::Vector3d>(data_->xfrc_applied + 6 * body + 3) += arm.cross(push.force_W_N);
  }
}

void MujocoWorld::ReadContacts() {
  for (FootTruth& foot : truth_.feet) {
    foot.f_F_W.setZero();
    foot.m_F_W.setZero();
    foot.in_contact = false;
  }
  truth_.body_touches_ground = false;
  truth_.self_contact_depth_m = 0.0;
  for (int i = 0; i < data_->ncon; ++i) {
    const mjContact& contact = data_->contact[i];
    const int body1 = model_->geom_bodyid[contact.geom1];
    const int body2 = model_->geom_bodyid[contact.geom2];
    // The contact frame's normal points from geom1 to geom2, and the force acts on geom2.
    if (body1 == kWorldBody) {
      ReadGroundContact(i, body2, 1.0);
    } else if (body2 == kWorldBody) {
      ReadGroundContact(i, body1, -1.0);
    } else {
      truth_.self_contact_depth_m = std::max(truth_.self_contact_depth_m, -contact.dist);
    }
  }
}

// The foot's site is still where the contact found it: mj_step1 has not been there.
void MujocoWorld::ReadGroundContact(int contact_id, int robot_body, double sign) {
  const mjContact& contact = data_->contact[contact_id];
  mjtNum wrench[6];  // [force; torque] in the contact's frame, at its place
  mj_contactForce(model_.get(), data_.get(), contact_id, wrench);
  const Eigen::Matrix3d R_WK = ConstMatrix3Map(contact.frame).transpose();
  const Eigen::Vector3d force_W = sign * (R_WK * ConstVector3Map(wrench));
  const Eigen::Vector3d torque_W = sign * (R_WK * ConstVector3Map(wrench + 3));
  bool is_foot = false;
  for (std::size_t i = 0; i < feet_.size(); ++i) {
    if (model_->body_weldid[robot_body] != feet_[i].weld) continue;
    FootTruth& foot = truth_.feet[i];
    const Eigen::Vector3d arm =
        ConstVector3Map(contact.pos) - ConstVector3Map(data_->site_xpos + 3 * feet_[i].site);
    foot.f_F_W += force_W;
    foot.m_F_W += torque_W + arm.cross(force_W);
    foot.in_contact = foot.in_contact || force_W.z() > 0.0;
    is_foot = true;
  }
  truth_.body_touches_ground = truth_.body_touches_ground || !is_foot;
}

void MujocoWorld::ReadState() {
  const mjModel* model = model_.get();
  mjData* data = data_.get();
  truth_.qpos = Eigen::Map<const Eigen::VectorXd>(data->qpos, model->nq);
  truth_.p_WB = ConstVector3Map(data->xpos + 3 * base_body_);
  truth_.q_WB = FromMuJoCo(data->xquat + 4 * base_body_);
  const BaseMotion base = base_.Read(*data);
  truth_.v_WB = base.v_WB;
  truth_.w_WB_B = base.w_WB_B;
  const CentroidalMotion motion = CentroidalMotionOf(*model, *data, base_body_);
  truth_.p_WC = motion.p_WC;
  truth_.v_WC = motion.v_WC;
  truth_.angular_momentum = motion.angular_momentum;
  ReadJoints();
  ReadFeet();
  ReadSensors();
}

void MujocoWorld::ReadJoints() {
  truth_.actuator_power_W = 0.0;
  truth_.num_saturated = servos_.num_saturated();
  for (std::size_t i = 0; i < joint_.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(i);
    truth_.joint_position[at] = data_->qpos[model_->jnt_qposadr[joint_[i]]];
    truth_.joint_velocity[at] = data_->qvel[model_->jnt_dofadr[joint_[i]]];
    truth_.joint_torque_Nm[at] = data_->actuator_force[i];
    truth_.actuator_power_W +=
        std::abs(data_->actuator_force[i] * data_->qvel[model_->jnt_dofadr[joint_[i]]]);
  }
}

void MujocoWorld::ReadFeet() {
  for (std::size_t i = 0; i < feet_.size(); ++i) {
    FootTruth& foot = truth_.feet[i];
    const int site = feet_[i].site;
    foot.p_WF = ConstVector3Map(data_->site_xpos + 3 * site);
    foot.R_WF = ConstMatrix3Map(data_->site_xmat + 9 * site);
    mjtNum twist[6];  // [angular; linear]
    mj_objectVelocity(model_.get(), data_.get(), mjOBJ_SITE, site, twist, 0);
    foot.v_WF = ConstVector3Map(twist + 3);
    foot.touch_N =
        feet_[i].touch >= 0 ? data_->sensordata[feet_[i].touch] : std::max(0.0, foot.f_F_W.z());
  }
}

void MujocoWorld::ReadSensors() {
  truth_.imu.q_WU = FromMuJoCo(data_->sensordata + imu_.orientation);
  truth_.imu.gyro_radps = ConstVector3Map(data_->sensordata + imu_.gyro);
  truth_.imu.accelerometer_mps2 = ConstVector3Map(data_->sensordata + imu_.accelerometer);
  // MuJoCo 2.2.2 tells what the parent does to the site's body (measured: -m g on a standing
  // foot); ours is what that body, the distal part, does to its parent.
  for (std::size_t i = 0; i < force_torque_.size(); ++i) {
    truth_.force_torque[i].force_N = -ConstVector3Map(data_->sensordata + force_torque_[i].force);
    truth_.force_torque[i].torque_Nm =
        -ConstVector3Map(data_->sensordata + force_torque_[i].torque);
  }
}

void MujocoWorld::CheckValid() {
  if (!is_valid()) return;
  for (int warning = 0; warning < mjNWARNING; ++warning) {
    if (data_->warning[warning].number == 0) continue;
    invalid_reason_ = mju_warningText(warning, data_->warning[warning].lastinfo);
    return;
  }
  if (!truth_.qpos.allFinite()) invalid_reason_ = "the state is not finite";
  const double farthest_m = truth_.p_WB.head<2>().cwiseAbs().maxCoeff();
  if (is_uneven_ && farthest_m > kGroundReach_m) {
    invalid_reason_ = "the robot left the ground, which is uneven and ends at 100 m";
  }
}

}  // namespace sidestep
