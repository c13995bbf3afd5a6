// SPDX-License-Identifier: BSD-3-Clause
#include "sim/world/mujoco_world.h"

#include <Eigen/Geometry>
#include <cmath>

#include "models/mjcf/quaternion.h"
#include "models/robot_description/home_pose.h"
#include "models/support/require.h"
#include "sim/world/world_model.h"

namespace sidestep {
namespace {

using ConstVector3Map = Eigen::Map<const Eigen::Vector3d>;
using ConstMatrix3Map = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>;

constexpr int kWorldBody = 0;

}  // namespace

MujocoWorld::MujocoWorld(const Scenario& scenario)
    : model_(CompileWorld(scenario)),
      data_(MakeData(*model_)),
      pushes_(scenario.pushes, scenario.world.step_s),
      mass_kg_(mj_getTotalmass(model_.get())) {
  ResolveNames(scenario);
  PlaceAtHome(*model_, scenario.description_of_robot, data_.get());
  mj_forward(model_.get(), data_.get());
  mj_step1(model_.get(), data_.get());
  ReadState();
  UpdatePushes(0);
}

int MujocoWorld::SensorAddress(const std::string& name) const {
  return model_->sensor_adr[RequireId(*model_, mjOBJ_SENSOR, name)];
}

void MujocoWorld::ResolveNames(const Scenario& scenario) {
  const RobotDescription& robot = scenario.description_of_robot;
  base_body_ = RequireId(*model_, mjOBJ_BODY, robot.base);
  imu_ = {SensorAddress(robot.imu + "_orientation"), SensorAddress(robot.imu + "_gyro"),
          SensorAddress(robot.imu + "_accelerometer")};
  for (const FootDescription& foot : robot.feet) {
    foot_site_.push_back(RequireId(*model_, mjOBJ_SITE, foot.frame));
    foot_touch_.push_back(SensorAddress(foot.name + "_touch"));
  }
  truth_.feet.resize(robot.feet.size());
  for (int actuator = 0; actuator < model_->nu; ++actuator) {
    const int joint = model_->actuator_trnid[2 * actuator];
    joint_.push_back(joint);
    joint_names_.emplace_back(mj_id2name(model_.get(), mjOBJ_JOINT, joint));
  }
  truth_.joint_position.setZero(model_->nu);
  truth_.joint_velocity.setZero(model_->nu);
  for (const Push& push : scenario.pushes) {
    PushedObject object;
    object.site = mj_name2id(model_.get(), mjOBJ_SITE, push.body.c_str());
    object.body = object.site >= 0 ? model_->site_bodyid[object.site]
                                   : RequireId(*model_, mjOBJ_BODY, push.body);
    pushed_.push_back(object);
  }
  pushed_poses_.resize(pushed_.size());
}

void MujocoWorld::Apply(const ActuatorCommand& command) {
  SIDESTEP_REQUIRE(command.torque_Nm.size() == model_->nu, command.torque_Nm.size());
  Eigen::Map<Eigen::VectorXd>(data_->ctrl, model_->nu) = command.torque_Nm;
}

void MujocoWorld::Step(Tick tick) {
  ApplyPushes();
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
  truth_.pushes = pushes_.At(tick, pushed_poses_, HeadingRad(truth_.q_WB));
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
    foot.in_contact = false;
  }
  truth_.body_touches_ground = false;
  for (int i = 0; i < data_->ncon; ++i) {
    const mjContact& contact = data_->contact[i];
    const int body1 = model_->geom_bodyid[contact.geom1];
    const int body2 = model_->geom_bodyid[contact.geom2];
    if (body1 != kWorldBody && body2 != kWorldBody) continue;
    // The contact frame's normal points from geom1 to geom2, and the force acts on geom2.
    const int robot_body = body1 == kWorldBody ? body2 : body1;
    const double sign = body1 == kWorldBody ? 1.0 : -1.0;
    mjtNum wrench[6];
    mj_contactForce(model_.get(), data_.get(), i, wrench);
    const Eigen::Vector3d force_W =
        sign * (ConstMatrix3Map(contact.frame).transpose() * ConstVector3Map(wrench));
    bool is_foot = false;
    for (std::size_t foot = 0; foot < truth_.feet.size(); ++foot) {
      if (model_->site_bodyid[foot_site_[foot]] != robot_body) continue;
      truth_.feet[foot].f_F_W += force_W;
      truth_.feet[foot].in_contact = truth_.feet[foot].in_contact || force_W.z() > 0.0;
      is_foot = true;
    }
    truth_.body_touches_ground = truth_.body_touches_ground || !is_foot;
  }
}

void MujocoWorld::ReadState() {
  const mjModel* model = model_.get();
  mjData* data = data_.get();
  const int root = model->body_jntadr[base_body_];
  const int velocity = model->jnt_dofadr[root];
  truth_.qpos = Eigen::Map<const Eigen::VectorXd>(data->qpos, model->nq);
  truth_.p_WB = ConstVector3Map(data->xpos + 3 * base_body_);
  truth_.q_WB = FromMuJoCo(data->xquat + 4 * base_body_);
  truth_.v_WB = ConstVector3Map(data->qvel + velocity);
  truth_.w_WB_B = ConstVector3Map(data->qvel + velocity + 3);
  mj_subtreeVel(model, data);
  truth_.p_WC = ConstVector3Map(data->subtree_com + 3 * base_body_);
  truth_.v_WC = ConstVector3Map(data->subtree_linvel + 3 * base_body_);
  truth_.angular_momentum = ConstVector3Map(data->subtree_angmom + 3 * base_body_);
  truth_.actuator_power_W = 0.0;
  for (std::size_t i = 0; i < joint_.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(i);
    truth_.joint_position[at] = data->qpos[model->jnt_qposadr[joint_[i]]];
    truth_.joint_velocity[at] = data->qvel[model->jnt_dofadr[joint_[i]]];
    truth_.actuator_power_W +=
        std::abs(data->actuator_force[i] * data->qvel[model->jnt_dofadr[joint_[i]]]);
  }
  for (std::size_t foot = 0; foot < foot_site_.size(); ++foot) {
    const int site = foot_site_[foot];
    truth_.feet[foot].p_WF = ConstVector3Map(data->site_xpos + 3 * site);
    mjtNum twist[6];  // [angular; linear]
    mj_objectVelocity(model, data, mjOBJ_SITE, site, twist, 0);
    truth_.feet[foot].v_WF = ConstVector3Map(twist + 3);
    truth_.feet[foot].touch_N = data->sensordata[foot_touch_[foot]];
  }
  truth_.imu.q_WU = FromMuJoCo(data->sensordata + imu_.orientation);
  truth_.imu.gyro_radps = ConstVector3Map(data->sensordata + imu_.gyro);
  truth_.imu.accelerometer_mps2 = ConstVector3Map(data->sensordata + imu_.accelerometer);
}

void MujocoWorld::CheckValid() {
  if (!is_valid()) return;
  for (int warning = 0; warning < mjNWARNING; ++warning) {
    if (data_->warning[warning].number == 0) continue;
    invalid_reason_ = mju_warningText(warning, data_->warning[warning].lastinfo);
    return;
  }
  if (!truth_.qpos.allFinite()) invalid_reason_ = "the state is not finite";
}

}  // namespace sidestep
