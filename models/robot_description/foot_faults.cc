// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "models/mjcf/mjcf.h"
#include "models/robot_description/fault_parts.h"
#include "models/robot_description/foot_shape.h"

namespace sidestep {
namespace {

using ConstVector3Map = Eigen::Map<const Eigen::Vector3d>;
using ConstMatrix3Map = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>;

// A sole frame and the shapes' lowest point: more would make the robot drop, or be thrown up.
constexpr double kSoleGap_m = 0.003;
constexpr double kVertexOutside_m = 0.002;
constexpr double kToeOut_rad = 0.5;  // feet of people turn out by 0.1 to 0.3

std::string BodyOf(const mjModel& model, int site) {
  const char* name = mj_id2name(&model, mjOBJ_BODY, model.site_bodyid[site]);
  return name != nullptr ? name : "";
}

/// Whether the vertices are on and within the shape.
void AddShapeFaults(const RobotAtHome& at_home, std::size_t i, int site,
                    std::vector<RobotFault>* faults) {
  const FootDescription& foot = at_home.robot.feet[i];
  const auto shape = FootShapeOf(at_home.model, at_home.data, site);
  if (!shape) {
    faults->push_back({FootKey(i, "frame"), "= '" + foot.frame + "' is on '" +
                                                BodyOf(at_home.model, site) +
                                                "', which has no collision shape to stand on"});
    return;
  }
  const double gap_m = foot.vertices_m.row(2).minCoeff() - foot.sole_height_m - shape->lowest_z_m;
  if (std::abs(gap_m) > kSoleGap_m) {
    faults->push_back({FootKey(i, "frame"), "= '" + foot.frame + "': its vertices are " +
                                                FigureText(std::abs(gap_m)) + " m " +
                                                (gap_m > 0.0 ? "above" : "below") +
                                                " the lowest point of the foot's collision shape"});
  }
  double farthest_m = kVertexOutside_m;
  Eigen::Index worst = -1;
  for (Eigen::Index vertex = 0; vertex < foot.vertices_m.cols(); ++vertex) {
    const double outside_m = DistanceOutside(shape->hull, foot.vertices_m.col(vertex).head<2>());
    if (outside_m <= farthest_m) continue;
    farthest_m = outside_m;
    worst = vertex;
  }
  if (worst < 0) return;
  faults->push_back({FootKey(i, "vertices_m." + std::to_string(worst)),
                     "is " + FigureText(farthest_m) +
                         " m outside the foot's collision shape, where the ground can't carry it"});
}

/// Whether z of the sole points up, more or less, and x to the front.
void AddAxisFaults(const RobotAtHome& at_home, std::size_t i, int site,
                   std::vector<RobotFault>* faults) {
  const FootDescription& foot = at_home.robot.feet[i];
  if (!IsFlat(foot)) return;
  const ConstMatrix3Map R_WF(at_home.data.site_xmat + 9 * site);
  const double tilt_rad = std::acos(std::clamp(R_WF(2, 2), -1.0, 1.0));
  if (tilt_rad > kUpsideDown_rad) {
    faults->push_back(
        {FootKey(i, "frame"), "= '" + foot.frame + "' has its z axis " + FigureText(tilt_rad) +
                                  " rad from upwards at the start; it must point up"});
    return;
  }
  const double yaw_rad = std::atan2(R_WF(1, 0), R_WF(0, 0));
  if (std::abs(yaw_rad) <= kToeOut_rad) return;
  const bool is_backwards = std::abs(yaw_rad) > 2.0;
  faults->push_back(
      {FootKey(i, "frame"),
       "= '" + foot.frame + "' has its x axis turned by " + FigureText(yaw_rad) +
           " rad from the world's at the start" + (is_backwards ? ": it points backwards" : "") +
           "; it must point to the toes, to the front (at most " + FigureText(kToeOut_rad) + ")"});
}

}  // namespace

void AddFootFaults(const RobotAtHome& at_home, std::vector<RobotFault>* faults) {
  const RobotDescription& robot = at_home.robot;
  std::vector<double> lateral_m;
  for (std::size_t i = 0; i < robot.feet.size(); ++i) {
    const int site = RequireId(at_home.model, mjOBJ_SITE, robot.feet[i].frame);
    AddAxisFaults(at_home, i, site, faults);
    AddShapeFaults(at_home, i, site, faults);
    lateral_m.push_back(at_home.data.site_xpos[3 * site + 1]);
  }
  // Of a robot in a plane FindSagittalPlane() has seen to it.
  if (robot.feet.size() != 2 || robot.base_freedom == BaseFreedom::kSagittal) return;
  if (lateral_m[0] > lateral_m[1]) return;
  faults->push_back({"feet", "must be in the order left, right: at the start the first one, '" +
                                 robot.feet[0].name + "', is " +
                                 FigureText(lateral_m[1] - lateral_m[0]) + " m to the right of '" +
                                 robot.feet[1].name + "'"});
}

}  // namespace sidestep
