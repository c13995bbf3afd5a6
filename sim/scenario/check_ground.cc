// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "models/robot_description/home_pose.h"
#include "models/support/config_node.h"
#include "sim/scenario/check_parts.h"

namespace sidestep {
namespace {

// What is narrower than 1 cm no foot can stand on or step into. (A little less: of decimal
// numbers.)
constexpr double kLeastWidth_m = 0.01 - 1e-9;
// Far more than a course of steps has; slabs are cut along every edge of every patch.
constexpr std::size_t kMostPatches = 200;

std::string ShortText(double length_m) { return NumberText(std::round(1e4 * length_m) / 1e4); }

/// The rectangle that a foot's sole covers, in W (m).
struct Sole {
  std::string foot;
  Eigen::Vector2d lower_m;
  Eigen::Vector2d upper_m;
};

/// Where the robot's soles are at the start.
std::vector<Sole> SolesAtHome(const RobotDescription& robot) {
  const HomePose home(robot);
  std::vector<Sole> soles;
  for (const FootDescription& foot : robot.feet) {
    const Eigen::Isometry3d X_WF = home.X_WO(foot.frame);
    const Eigen::Matrix3Xd vertices_W =
        (X_WF.linear() * foot.vertices_m).colwise() + X_WF.translation();
    soles.push_back({foot.name, vertices_W.topRows<2>().rowwise().minCoeff(),
                     vertices_W.topRows<2>().rowwise().maxCoeff()});
  }
  return soles;
}

void CheckPatch(const GroundPatch& patch, const std::string& path, const ConfigTree& root) {
  if (patch.to_x_m - patch.from_x_m < kLeastWidth_m) {
    FailAtPath(root, path + ".to_x_m",
               "= " + NumberText(patch.to_x_m) +
                   " must lie 0.01 m or more beyond from_x_m = " + NumberText(patch.from_x_m));
  }
  if (patch.to_y_m - patch.from_y_m < kLeastWidth_m) {
    FailAtEither(root, path + ".to_y_m", path + ".from_y_m",
                 "= " + NumberText(patch.to_y_m) +
                     " must lie 0.01 m or more beyond from_y_m = " + NumberText(patch.from_y_m));
  }
}

/// What is higher or lower than the rest must not be where the robot stands as a run begins.
void CheckStart(const GroundPatch& patch, const std::string& path, const std::vector<Sole>& soles,
                const ConfigTree& root) {
  for (const Sole& sole : soles) {
    const bool is_clear = patch.to_x_m <= sole.lower_m.x() || patch.from_x_m >= sole.upper_m.x() ||
                          patch.to_y_m <= sole.lower_m.y() || patch.from_y_m >= sole.upper_m.y();
    if (is_clear) continue;
    const auto span = [&](int axis) {
      return ShortText(sole.lower_m[axis]) + " to " + ShortText(sole.upper_m[axis]) + " m";
    };
    FailAtPath(root, path,
               "lies where the robot starts: foot '" + sole.foot + "' stands at x = " + span(0) +
                   ", y = " + span(1));
  }
}

bool Overlap(const GroundPatch& a, const GroundPatch& b) {
  return a.from_x_m < b.to_x_m && b.from_x_m < a.to_x_m && a.from_y_m < b.to_y_m &&
         b.from_y_m < a.to_y_m;
}

}  // namespace

void CheckGround(const Scenario& scenario, const ConfigTree& root) {
  const std::vector<GroundPatch>& ground = scenario.world.ground;
  if (!ground.empty() && scenario.plant == Plant::kCentroidal) {
    FailAtPath(root, "world.ground",
               "means nothing on the centroidal plant, whose feet go where they are told; leave it "
               "out, or write plant: mujoco");
  }
  if (ground.empty()) return;
  if (ground.size() > kMostPatches) {
    FailAtPath(root, "world.ground",
               "has " + std::to_string(ground.size()) + " patches; at most " +
                   std::to_string(kMostPatches) + " are allowed");
  }
  const std::vector<Sole> soles = SolesAtHome(scenario.robot);
  for (std::size_t i = 0; i < ground.size(); ++i) {
    const std::string path = "world.ground." + std::to_string(i);
    CheckPatch(ground[i], path, root);
    CheckStart(ground[i], path, soles, root);
    for (std::size_t j = 0; j < i; ++j) {
      if (!Overlap(ground[i], ground[j])) continue;
      FailAtPath(root, path, "overlaps world.ground." + std::to_string(j));
    }
  }
}

}  // namespace sidestep
