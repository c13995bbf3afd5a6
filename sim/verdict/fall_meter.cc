// SPDX-License-Identifier: BSD-3-Clause
#include "sim/verdict/fall_meter.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "sim/world/ground.h"

namespace sidestep {
namespace {

std::string Compared(const char* what, double measured, const char* relation, double bound,
                     const char* unit) {
  char text[128];
  std::snprintf(text, sizeof text, "%s %.3f %s is %s %.3f %s", what, measured, unit, relation,
                bound, unit);
  return text;
}

}  // namespace

Eigen::Vector3d UprightAxis(const RobotDescription& robot, Plant plant) {
  if (plant == Plant::kCentroidal) return Eigen::Vector3d::UnitZ();
  const Eigen::Vector3d& rpy_rad = robot.base_rpy_rad;
  const double roll_rad = rpy_rad.x(), pitch_rad = rpy_rad.y();
  // Last row of Rz(yaw) Ry(pitch) Rx(roll).
  return {-std::sin(pitch_rad), std::cos(pitch_rad) * std::sin(roll_rad),
          std::cos(pitch_rad) * std::cos(roll_rad)};
}

double TiltRad(const Eigen::Quaterniond& q_WB, const Eigen::Vector3d& up_B) {
  // atan2 keeps its digits near upright, where acos loses half of them.
  const Eigen::Vector3d up_W = q_WB * up_B;
  return std::atan2(up_W.head<2>().norm(), up_W.z());
}

FallMeter::FallMeter(const RobotDescription& robot, Plant plant, const VerdictParams& bounds,
                     std::vector<GroundPatch> ground)
    : bounds_(bounds),
      ground_(std::move(ground)),
      is_centroidal_(plant == Plant::kCentroidal),
      up_B_(UprightAxis(robot, plant)),
      nominal_height_m_(is_centroidal_ ? robot.com_height_m : robot.base_height_m) {}

void FallMeter::Add(Tick tick, const WorldTruth& truth) {
  const double height_m = is_centroidal_ ? truth.p_WC.z() : truth.p_WB.z();
  tilt_rad_ = TiltRad(truth.q_WB, up_B_);
  min_height_m_ = std::min(min_height_m_, height_m);
  max_height_m_ = std::max(max_height_m_, height_m);
  max_tilt_rad_ = std::max(max_tilt_rad_, tilt_rad_);
  if (fall_tick_) return;

  const Eigen::Vector3d& watched_W = is_centroidal_ ? truth.p_WC : truth.p_WB;
  const double over_ground_m = height_m - GroundHeight_m(ground_, watched_W.head<2>());
  const double lowest_m = bounds_.min_base_height_ratio * nominal_height_m_;
  if (truth.body_touches_ground) {
    cause_ = "a body other than a foot touches the ground";
  } else if (over_ground_m < lowest_m) {
    cause_ = Compared(is_centroidal_ ? "CoM height" : "base height", over_ground_m, "below",
                      lowest_m, "m");
  } else if (tilt_rad_ > bounds_.max_tilt_rad) {
    cause_ = Compared("base tilt", tilt_rad_, "above", bounds_.max_tilt_rad, "rad");
  } else {
    return;
  }
  fall_tick_ = tick;
}

}  // namespace sidestep
