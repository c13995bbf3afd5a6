// SPDX-License-Identifier: BSD-3-Clause
#include "models/robot_description/sagittal_plane.h"

#include <cmath>

#include "models/mjcf/base_joints.h"
#include "models/mjcf/mjcf.h"
#include "models/robot_description/home_pose.h"
#include "models/support/config_error.h"
#include "models/support/config_node.h"

namespace sidestep {
namespace {

using ConstVector3Map = Eigen::Map<const Eigen::Vector3d>;
using ConstMatrix3Map = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>;

// Of lengths (m) and of axes that were turned a few times: no model is as exact by intention.
constexpr double kRounding = 1e-9;

[[noreturn]] void Fail(const RobotDescription& robot, const std::string& what) {
  throw ConfigError(robot.model->file.string() + ": error: of a base that moves in a plane " +
                    what);
}

// Axes as they are at home: joints of the plane keep them there for good.
void CheckJoints(const mjModel& model, const mjData& data, const RobotDescription& robot) {
  for (int joint = 0; joint < model.njnt; ++joint) {
    const ConstVector3Map axis_W(data.xaxis + 3 * joint);
    const bool turns = model.jnt_type[joint] == mjJNT_HINGE &&
                       (axis_W - axis_W.y() * Eigen::Vector3d::UnitY()).norm() < kRounding;
    const bool slides = model.jnt_type[joint] == mjJNT_SLIDE && std::abs(axis_W.y()) < kRounding;
    if (turns || slides) continue;
    const char* name = mj_id2name(&model, mjOBJ_JOINT, joint);
    Fail(robot, "joint '" + std::string(name != nullptr ? name : "") +
                    "' must turn about y or slide along x and z");
  }
}

// At the feet's own place, if it is known.
[[noreturn]] void FailAtFeet(const RobotDescription& robot, const ConfigNode* feet,
                             const std::string& what) {
  if (feet == nullptr) Fail(robot, what);
  feet->Fail("of a base that moves in a plane: " + what);
}

void FindFeet(const mjModel& model, const mjData& data, const ConfigNode* feet,
              RobotDescription* robot) {
  double sum_m = 0.0;
  for (FootDescription& foot : robot->feet) {
    const int site = RequireId(model, mjOBJ_SITE, foot.frame);
    foot.lateral_m = data.site_xpos[3 * site + 1];
    sum_m += foot.lateral_m;
    const ConstMatrix3Map R_WF(data.site_xmat + 9 * site);
    if ((R_WF.col(1) - Eigen::Vector3d::UnitY()).norm() > kRounding) {
      FailAtFeet(*robot, feet, "frame '" + foot.frame + "' must have its y axis along the world's");
    }
  }
  if (std::abs(sum_m) > kRounding || robot->feet.front().lateral_m < -kRounding) {
    FailAtFeet(*robot, feet,
               "the feet must be as far to the left, the first one's side, as to the right");
  }
}

// Index of the column that has x and z of `vertex_m`; the number of columns if none has.
Eigen::Index FindInPlane(const Eigen::Matrix3Xd& vertices_m, Eigen::Index size,
                         const Eigen::Vector3d& vertex_m) {
  Eigen::Index at = 0;
  while (at < size && (vertices_m.col(at) - vertex_m).norm() > kRounding) ++at;
  return at;
}

void MoveIntoPlane(FootDescription* foot) {
  const Eigen::Matrix3Xd corners_m = foot->vertices_m;
  const Eigen::Index num_corners = corners_m.cols();
  Eigen::VectorXd corner_shares = foot->force_shares;
  if (corner_shares.size() == 0) {
    corner_shares.setConstant(num_corners, 1.0 / static_cast<double>(num_corners));
  }
  Eigen::VectorXd shares = Eigen::VectorXd::Zero(num_corners);
  Eigen::Index size = 0;
  for (Eigen::Index corner = 0; corner < num_corners; ++corner) {
    const Eigen::Vector3d vertex_m(corners_m(0, corner), -foot->lateral_m, corners_m(2, corner));
    const Eigen::Index at = FindInPlane(foot->vertices_m, size, vertex_m);
    if (at == size) foot->vertices_m.col(size++) = vertex_m;
    shares[at] += corner_shares[corner];
  }
  foot->vertices_m.conservativeResize(3, size);
  shares.conservativeResize(size);
  const bool are_equal = shares.maxCoeff() - shares.minCoeff() < kRounding;
  foot->force_shares = are_equal ? Eigen::VectorXd() : shares;
}

}  // namespace

void FindSagittalPlane(RobotDescription* robot, const ConfigNode* feet) {
  const RobotModel& text = RequireModel(*robot);
  const MjModelPtr model = CompileMjcf(text.simulated_mjcf, "", text.file);
  const int body = RequireId(*model, mjOBJ_BODY, robot->base);
  const BaseJoints base(*model, body, text.file.string());
  robot->base_freedom = base.freedom();
  if (!base.is_sagittal()) return;
  const MjDataPtr data = MakeData(*model);
  PlaceAtHome(*model, *robot, data.get());
  mj_comPos(model.get(), data.get());
  CheckJoints(*model, *data, *robot);
  FindFeet(*model, *data, feet, robot);
  const double com_y_m = data->subtree_com[3 * body + 1];
  if (std::abs(com_y_m) > kRounding) {
    Fail(*robot,
         "the CoM must be at y = 0, not at " + NumberText(std::round(1e6 * com_y_m) / 1e6) + " m");
  }
}

RobotDescription InItsPlane(const RobotDescription& robot) {
  RobotDescription seen = robot;
  if (robot.base_freedom != BaseFreedom::kSagittal) return seen;
  for (FootDescription& foot : seen.feet) MoveIntoPlane(&foot);
  return seen;
}

}  // namespace sidestep
