// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// robot_on_floor: a robot at home over a floor, held by its servos.

#include <mujoco/mujoco.h>

#include <Eigen/Core>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "models/mjcf/mjcf.h"
#include "models/robot_description/home_pose.h"
#include "models/robot_description/robot_description.h"

namespace sidestep {

/// Two names of bodies in alphabetical order; the floor's is "world".
using ContactPair = std::pair<std::string, std::string>;

class RobotOnFloor {
 public:
  explicit RobotOnFloor(const RobotDescription& robot)
      : robot_(robot),
        model_(CompileMjcf(R"(<mujoco><option timestep="0.001"/><worldbody>
              <geom name="floor" type="plane" size="0 0 1" contype="1" conaffinity="1"/>
              </worldbody><include file="robot.xml"/></mujoco>)",
                           RequireModel(robot).drawn_mjcf, robot.model->file)),
        data_(MakeData(*model_)) {
    PlaceAtHome(*model_, robot, data_.get());
    home_.assign(data_->qpos, data_->qpos + model_->nq);
    mj_forward(model_.get(), data_.get());
  }

  const mjModel& model() const { return *model_; }
  mjData& data() { return *data_; }

  int Body(const std::string& name) const { return RequireId(*model_, mjOBJ_BODY, name); }
  int Site(const std::string& name) const { return RequireId(*model_, mjOBJ_SITE, name); }

  void SetJoint(const std::string& name, double position) {
    data_->qpos[model_->jnt_qposadr[RequireId(*model_, mjOBJ_JOINT, name)]] = position;
  }

  /// Servos hold the home posture, within the motors' limits.
  void Stand(int num_steps) {
    for (int step = 0; step < num_steps; ++step) {
      mj_step1(model_.get(), data_.get());
      for (int i = 0; i < model_->nu; ++i) {
        const JointDescription& servo = robot_.joints[static_cast<std::size_t>(i)];
        const int joint = model_->actuator_trnid[2 * i];
        const int q = model_->jnt_qposadr[joint];
        data_->ctrl[i] = servo.servo_stiffness_Nm_per_rad *
                             (home_[static_cast<std::size_t>(q)] - data_->qpos[q]) -
                         servo.servo_damping_Nms_per_rad * data_->qvel[model_->jnt_dofadr[joint]];
      }
      mj_step2(model_.get(), data_.get());
    }
    mj_forward(model_.get(), data_.get());
  }

  /// MuJoCo's reading of a force sensor, turned into the world's axes (N).
  Eigen::Vector3d SensorForce_W(const std::string& name) const {
    const int sensor = RequireId(*model_, mjOBJ_SENSOR, name + "_force");
    Eigen::Vector3d force_W;
    mju_rotVecMat(force_W.data(), data_->sensordata + model_->sensor_adr[sensor],
                  data_->site_xmat + 9 * Site(name));
    return force_W;
  }

  Eigen::Vector3d Com_W() const {
    return Eigen::Map<const Eigen::Vector3d>(data_->subtree_com + 3 * Body(robot_.base));
  }

  /// Bodies that touch, each pair once.
  std::set<ContactPair> Contacts() const {
    std::set<ContactPair> pairs;
    for (int i = 0; i < data_->ncon; ++i) {
      std::string one = BodyOfGeom(data_->contact[i].geom1);
      std::string other = BodyOfGeom(data_->contact[i].geom2);
      if (other < one) std::swap(one, other);
      pairs.insert({one, other});
    }
    return pairs;
  }

 private:
  std::string BodyOfGeom(int geom) const {
    return mj_id2name(model_.get(), mjOBJ_BODY, model_->geom_bodyid[geom]);
  }

  const RobotDescription robot_;
  MjModelPtr model_;
  MjDataPtr data_;
  std::vector<mjtNum> home_;
};

}  // namespace sidestep
