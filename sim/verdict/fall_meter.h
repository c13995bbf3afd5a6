// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// fall_meter: whether and when the robot fell, and how low and tilted it got.

#include <Eigen/Geometry>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "controller/types/tick.h"
#include "models/robot_description/robot_description.h"
#include "sim/scenario/scenario.h"
#include "sim/world/world.h"

namespace sidestep {

/// Axis of B that points up at the start: z, unless the robot's base_rpy_rad tilts it. Unit length.
/// @param robot  The nominal one. @param plant  The centroidal one has no attitude: z.
Eigen::Vector3d UprightAxis(const RobotDescription& robot, Plant plant);

/// Angle between an axis of B and the vertical (rad), in [0, pi].
double TiltRad(const Eigen::Quaterniond& q_WB,
               const Eigen::Vector3d& up_B = Eigen::Vector3d::UnitZ());

/// The first of these is the fall: a body other than a foot touches the ground, the base (the CoM
/// on the centroidal plant) is below verdict.min_base_height_ratio of its nominal height, or it
/// tilts beyond verdict.max_tilt_rad. That height counts from the ground below it; the extremes,
/// which go on being measured after the fall, from z = 0.
class FallMeter {
 public:
  /// @param robot  The nominal one: its heights and its attitude at the start.
  /// @param ground  Of the world.
  FallMeter(const RobotDescription& robot, Plant plant, const VerdictParams& bounds,
            std::vector<GroundPatch> ground = {});

  /// Takes the truth of one tick; it must be finite.
  void Add(Tick tick, const WorldTruth& truth);

  bool has_fallen() const { return fall_tick_.has_value(); }

  /// Tick of the first sign of the fall, and what it was, in one line.
  std::optional<Tick> fall_tick() const { return fall_tick_; }
  const std::string& cause() const { return cause_; }

  double min_height_m() const { return min_height_m_; }  ///< Infinite before the first tick.
  double max_height_m() const { return max_height_m_; }  ///< Likewise.
  double nominal_height_m() const { return nominal_height_m_; }
  double tilt_rad() const { return tilt_rad_; }  ///< At the last tick; see TiltRad.
  double max_tilt_rad() const { return max_tilt_rad_; }

 private:
  VerdictParams bounds_;
  std::vector<GroundPatch> ground_;
  bool is_centroidal_;
  Eigen::Vector3d up_B_;     ///< UprightAxis().
  double nominal_height_m_;  ///< Of what is watched, by the robot's description.
  double min_height_m_{std::numeric_limits<double>::infinity()};
  double max_height_m_{-std::numeric_limits<double>::infinity()};
  double tilt_rad_{0.0};
  double max_tilt_rad_{0.0};
  std::optional<Tick> fall_tick_;
  std::string cause_;
};

}  // namespace sidestep
