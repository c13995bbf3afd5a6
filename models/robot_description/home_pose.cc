// SPDX-License-Identifier: BSD-3-Clause
#include "models/robot_description/home_pose.h"

#include <Eigen/Geometry>

#include "models/mjcf/base_joints.h"
#include "models/mjcf/mjcf.h"

namespace sidestep {
namespace {

Eigen::Quaterniond FromRpy(const Eigen::Vector3d& rpy_rad) {
  return Eigen::AngleAxisd(rpy_rad.z(), Eigen::Vector3d::UnitZ()) *
         Eigen::AngleAxisd(rpy_rad.y(), Eigen::Vector3d::UnitY()) *
         Eigen::AngleAxisd(rpy_rad.x(), Eigen::Vector3d::UnitX());
}

}  // namespace

void PlaceAtHome(const mjModel& model, const RobotDescription& robot, mjData* data) {
  const int body = RequireId(model, mjOBJ_BODY, robot.base);
  const BaseJoints base(model, body, RequireModel(robot).file.string());
  for (int joint = 0; joint < model.njnt; ++joint) {  // wherever the model's reference is
    const bool is_scalar =
        model.jnt_type[joint] == mjJNT_HINGE || model.jnt_type[joint] == mjJNT_SLIDE;
    if (is_scalar) data->qpos[model.jnt_qposadr[joint]] = 0.0;
  }
  for (const auto& [name, position] : robot.home) {
    data->qpos[model.jnt_qposadr[RequireId(model, mjOBJ_JOINT, name)]] = position;
  }
  BaseMotion at_home;
  at_home.p_WB.z() = robot.base_height_m;
  at_home.q_WB = FromRpy(robot.base_rpy_rad);
  base.Write(at_home, data);
  mj_kinematics(&model, data);
  mjtNum midpoint[3] = {0, 0, 0};
  for (const FootDescription& foot : robot.feet) {
    const int site = RequireId(model, mjOBJ_SITE, foot.frame);
    mju_addToScl3(midpoint, data->site_xpos + 3 * site,
                  1.0 / static_cast<double>(robot.feet.size()));
  }
  at_home.p_WB.x() -= midpoint[0];
  at_home.p_WB.y() -= midpoint[1];
  base.Write(at_home, data);
  mj_kinematics(&model, data);
}

HomePose::HomePose(const RobotDescription& robot)
    : model_(CompileMjcf(RequireModel(robot).simulated_mjcf, "", robot.model->file)),
      data_(MakeData(*model_)) {
  PlaceAtHome(*model_, robot, data_.get());
}

Eigen::Isometry3d HomePose::X_WO(const std::string& name) const {
  const int site = mj_name2id(model_.get(), mjOBJ_SITE, name.c_str());
  const int body = site >= 0 ? -1 : RequireId(*model_, mjOBJ_BODY, name);
  const mjtNum* place = site >= 0 ? data_->site_xpos + 3 * site : data_->xpos + 3 * body;
  const mjtNum* axes = site >= 0 ? data_->site_xmat + 9 * site : data_->xmat + 9 * body;
  Eigen::Isometry3d X_WO;
  X_WO.linear() = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(axes);
  X_WO.translation() = Eigen::Map<const Eigen::Vector3d>(place);
  return X_WO;
}

}  // namespace sidestep
