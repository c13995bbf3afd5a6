// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// path_meter: how far the CoM strays from its nominal motion, and when it is back for good.
//
// Path error: with `follow: path`, the horizontal distance of the CoM to the line that the nominal
// CoM draws, looked for within one gait cycle before and after; with `follow: capture_point`, where
// the nominal motion shifts with the robot, to the nominal CoM of the same instant. Speed error:
// horizontal CoM velocity less the nominal one, averaged over the last gait cycle (or what there is
// of it), as a length.

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "controller/types/control_tick.h"
#include "controller/types/gait_params.h"
#include "controller/types/tick.h"
#include "sim/scenario/scenario.h"
#include "sim/world/world.h"

namespace sidestep {

/// One period of a gait (s): every foot has stepped once. A stand, which has none, counts as 1 s.
/// @param num_feet  Of the robot; a run alternates them, a hop uses all at once.
double GaitCycle_s(const GaitParams& gait, std::size_t num_feet);

/// NaN where there was nothing to measure.
struct PathFigures {
  double final_path_error_m;
  double max_path_error_m;
  double final_speed_error_mps;
  /// From `push_end` until path error < 0.05 m and speed error < 0.1 m/s last to the end of the
  /// run; infinite if they don't, NaN if there is no push.
  double recovery_time_s;
};

class PathMeter {
 public:
  explicit PathMeter(const Scenario& scenario);

  /// Takes a control tick; ticks ascend.
  void Add(Tick tick, const WorldTruth& truth, const ComReference& reference);

  /// @param push_end  Tick at which the last push has ended, if there is one.
  PathFigures Conclude(std::optional<Tick> push_end) const;

 private:
  struct Sample {
    Tick tick;
    Eigen::Vector2d p_WC;
    Eigen::Vector2d reference_p_WC;
    Eigen::Vector2d drift_m;  ///< Sum of the speed errors up to this sample, times the period.
  };

  double PathError(std::size_t at) const;
  double SpeedError(std::size_t at) const;
  std::size_t CycleSamples(std::size_t at) const;

  double tick_s_;
  double period_s_;  ///< Between control ticks.
  bool follows_robot_;
  std::vector<GaitParams> gait_;
  std::size_t num_feet_;
  std::vector<Sample> samples_;
};

}  // namespace sidestep
