// SPDX-License-Identifier: BSD-3-Clause
#include "models/robot_description/robot_faults.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "models/mjcf/mjcf.h"
#include "models/robot_description/fault_parts.h"
#include "models/robot_description/foot_shape.h"
#include "models/robot_description/home_pose.h"
#include "models/support/config_error.h"
#include "models/support/config_node.h"
#include "models/support/convex_hull.h"

namespace sidestep {
namespace {

using ConstVector3Map = Eigen::Map<const Eigen::Vector3d>;
using ConstMatrix3Map = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>;

constexpr double kJointRounding = 1e-6;   // rad or m
constexpr double kSoleHeight_m = 0.003;   // above or in the floor
constexpr double kSoleTilt_rad = 0.02;    // 2 mm at the toes of a foot of 20 cm
constexpr double kComHeightShare = 0.02;  // of com_height_m: 1 % of omega

void AddJointFaults(const RobotAtHome& at_home, std::vector<RobotFault>* faults) {
  const mjModel& model = at_home.model;
  for (int joint = 0; joint < model.njnt; ++joint) {
    const char* name = mj_id2name(&model, mjOBJ_JOINT, joint);
    const bool is_scalar =
        model.jnt_type[joint] == mjJNT_HINGE || model.jnt_type[joint] == mjJNT_SLIDE;
    if (name == nullptr || !is_scalar || model.jnt_limited[joint] == 0) continue;
    const double position = at_home.data.qpos[model.jnt_qposadr[joint]];
    const double lower = model.jnt_range[2 * joint];
    const double upper = model.jnt_range[2 * joint + 1];
    const double beyond = std::max(lower - position, position - upper);
    if (beyond <= kJointRounding) continue;
    const char* unit = model.jnt_type[joint] == mjJNT_SLIDE ? " m" : " rad";
    faults->push_back(
        {"home." + std::string(name), "= " + FigureText(position) + " is " + FigureText(beyond) +
                                          unit + " outside the joint's range of " +
                                          FigureText(lower) + " to " + FigureText(upper)});
  }
}

/// A foot's sole as it stands at the start.
struct Sole {
  double height_m{0.0};  ///< Of its middle above the floor.
  double tilt_rad{0.0};
};

Sole SoleAtHome(const RobotAtHome& at_home, const FootDescription& foot) {
  const int site = RequireId(at_home.model, mjOBJ_SITE, foot.frame);
  const Eigen::Vector3d z_F = ConstMatrix3Map(at_home.data.site_xmat + 9 * site).row(2);
  return {at_home.data.site_xpos[3 * site + 2] + z_F.dot(foot.vertices_m.rowwise().mean()) -
              foot.sole_height_m,
          std::acos(std::clamp(z_F.z(), -1.0, 1.0))};
}

/// Whether soles are level, as high as each other, and on the floor.
void AddSoleFaults(const RobotAtHome& at_home, const std::vector<Sole>& soles, double mean_m,
                   std::vector<RobotFault>* faults) {
  const RobotDescription& robot = at_home.robot;
  for (std::size_t i = 0; i < soles.size(); ++i) {
    const double tilt_rad = soles[i].tilt_rad;
    if (!IsFlat(robot.feet[i]) || tilt_rad <= kSoleTilt_rad || tilt_rad > kUpsideDown_rad) continue;
    faults->push_back({"home", "tilts the sole of foot '" + robot.feet[i].name + "' by " +
                                   FigureText(tilt_rad) +
                                   " rad at the start; it must be level (within " +
                                   FigureText(kSoleTilt_rad) + ")"});
  }
  const auto [low, high] = std::minmax_element(
      soles.begin(), soles.end(),
      [](const Sole& left, const Sole& right) { return left.height_m < right.height_m; });
  if (high->height_m - low->height_m > kSoleHeight_m) {
    const auto name = [&](auto sole) {
      return "'" + robot.feet[static_cast<std::size_t>(sole - soles.begin())].name + "'";
    };
    faults->push_back({"home", "puts foot " + name(high) + " " +
                                   FigureText(high->height_m - low->height_m) + " m higher than " +
                                   name(low) + " at the start"});
  }
  // A sole that is tilted turns about a joint beside its middle, which levelling will move.
  double allowance_m = kSoleHeight_m;
  for (std::size_t i = 0; i < soles.size(); ++i) {
    const double reach_m = robot.feet[i].vertices_m.colwise().norm().maxCoeff();
    if (soles[i].tilt_rad > kSoleTilt_rad) allowance_m += soles[i].tilt_rad * reach_m;
  }
  if (std::abs(mean_m) <= allowance_m) return;
  faults->push_back(
      {"base_height_m", "= " + FigureText(robot.base_height_m) + " puts the soles " +
                            FigureText(std::abs(mean_m)) + " m " +
                            (mean_m > 0.0 ? "above" : "into") + " the floor at the start; " +
                            FigureText(robot.base_height_m - mean_m) + " puts them on it"});
}

void AddComFaults(const RobotAtHome& at_home, double sole_height_m,
                  std::vector<RobotFault>* faults) {
  const RobotDescription& robot = at_home.robot;
  const int base = RequireId(at_home.model, mjOBJ_BODY, robot.base);
  const Eigen::Vector3d p_WC = ConstVector3Map(at_home.data.subtree_com + 3 * base);
  const double height_m = p_WC.z() - sole_height_m;
  if (std::abs(robot.com_height_m - height_m) > kComHeightShare * height_m) {
    faults->push_back({"com_height_m", "= " + FigureText(robot.com_height_m) + " is " +
                                           FigureText(std::abs(robot.com_height_m - height_m)) +
                                           " m " +
                                           (robot.com_height_m > height_m ? "above" : "below") +
                                           " the CoM at the start, which is " +
                                           FigureText(height_m) + " m above the soles"});
  }
  std::vector<Eigen::Vector2d> vertices_W;
  for (const FootDescription& foot : robot.feet) {
    if (!IsFlat(foot)) return;  // whether it can balance is not told by where it starts
    const int site = RequireId(at_home.model, mjOBJ_SITE, foot.frame);
    const Eigen::Matrix3d R_WF = ConstMatrix3Map(at_home.data.site_xmat + 9 * site);
    const ConstVector3Map p_WF(at_home.data.site_xpos + 3 * site);
    for (Eigen::Index i = 0; i < foot.vertices_m.cols(); ++i) {
      vertices_W.emplace_back((p_WF + R_WF * foot.vertices_m.col(i)).head<2>());
    }
  }
  const double outside_m = DistanceOutside(ConvexHull(std::move(vertices_W)), p_WC.head<2>());
  if (outside_m <= 0.0) return;
  faults->push_back(
      {"home", "puts the CoM " + FigureText(outside_m) +
                   " m beside the soles at the start, at x = " + FigureText(p_WC.x()) +
                   ", y = " + FigureText(p_WC.y()) + " m from their middle"});
}

}  // namespace

std::string FigureText(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.4g", std::round(1e5 * value) / 1e5);
  return text.data();
}

RobotDescription ReadSoundRobot(const std::filesystem::path& file) {
  RobotDescription robot = ReadRobotDescription(file);
  const std::vector<RobotFault> faults = RobotFaults(robot);
  if (faults.empty()) return robot;
  const ConfigTree tree = ReadConfigFile(file);
  std::vector<std::string> messages;
  for (const RobotFault& fault : faults) {
    try {
      FailAtPath(tree, fault.key, fault.what);
    } catch (const ConfigError& error) {
      messages.emplace_back(error.what());
    }
  }
  throw ConfigError(messages);
}

std::vector<RobotFault> RobotFaults(const RobotDescription& robot) {
  std::vector<RobotFault> faults;
  if (!robot.model) return faults;
  const MjModelPtr model = CompileMjcf(robot.model->simulated_mjcf, "", robot.model->file);
  const MjDataPtr data = MakeData(*model);
  PlaceAtHome(*model, robot, data.get());
  mj_comPos(model.get(), data.get());
  const RobotAtHome at_home{robot, *model, *data};

  std::vector<Sole> soles;
  double mean_m = 0.0;
  for (const FootDescription& foot : robot.feet) {
    soles.push_back(SoleAtHome(at_home, foot));
    mean_m += soles.back().height_m / static_cast<double>(robot.feet.size());
  }
  AddComFaults(at_home, mean_m, &faults);
  AddJointFaults(at_home, &faults);
  AddSoleFaults(at_home, soles, mean_m, &faults);
  AddFootFaults(at_home, &faults);
  AddLegFaults(at_home, &faults);
  AddSensorFaults(at_home, &faults);
  return faults;
}

}  // namespace sidestep
