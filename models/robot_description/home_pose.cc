// SPDX-License-Identifier: BSD-3-Clause
#include "models/robot_description/home_pose.h"

#include <Eigen/Geometry>

#include "models/mjcf/mjcf.h"
#include "models/mjcf/quaternion.h"

namespace sidestep {
namespace {

Eigen::Quaterniond FromRpy(const Eigen::Vector3d& rpy_rad) {
  return Eigen::AngleAxisd(rpy_rad.z(), Eigen::Vector3d::UnitZ()) *
         Eigen::AngleAxisd(rpy_rad.y(), Eigen::Vector3d::UnitY()) *
         Eigen::AngleAxisd(rpy_rad.x(), Eigen::Vector3d::UnitX());
}

}  // namespace

void PlaceAtHome(const mjModel& model, const RobotDescription& robot, mjData* data) {
  const int base = RequireId(model, mjOBJ_BODY, robot.base);
  mjtNum* root = data->qpos + model.jnt_qposadr[model.body_jntadr[base]];
  mju_zero3(root);
  root[2] = robot.base_height_m;
  ToMuJoCo(FromRpy(robot.base_rpy_rad), root + 3);
  for (int joint = 0; joint < model.njnt; ++joint) {  // wherever the model's reference is
    const bool is_scalar =
        model.jnt_type[joint] == mjJNT_HINGE || model.jnt_type[joint] == mjJNT_SLIDE;
    if (is_scalar) data->qpos[model.jnt_qposadr[joint]] = 0.0;
  }
  for (const auto& [name, position] : robot.home) {
    data->qpos[model.jnt_qposadr[RequireId(model, mjOBJ_JOINT, name)]] = position;
  }
  mj_kinematics(&model, data);
  mjtNum midpoint[3] = {0, 0, 0};
  for (const FootDescription& foot : robot.feet) {
    const int site = RequireId(model, mjOBJ_SITE, foot.frame);
    mju_addToScl3(midpoint, data->site_xpos + 3 * site,
                  1.0 / static_cast<double>(robot.feet.size()));
  }
  root[0] -= midpoint[0];
  root[1] -= midpoint[1];
  mj_kinematics(&model, data);
}

}  // namespace sidestep
