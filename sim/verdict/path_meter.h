// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// path_meter: how far the CoM strays from its nominal path, and how it moves beside it.
//
// The path is a line, not a timetable: the CoM's offset goes from the nearest point of the line
// that the nominal CoM draws on the ground, looked for within one gait cycle before and after where
// on the line the robot was last. So a robot that is late or early is not charged for its phase, at
// whatever it has accumulated, and one that stops is as far off the path as where it stopped: its
// speed says so. Its pace is that of where it is: one that is late still walks where the clock has
// it stand. All means are over the last gait cycle, or what there is of it.

#include <Eigen/Core>
#include <limits>
#include <vector>

#include "controller/types/gait_params.h"
#include "controller/types/tick.h"
#include "sim/scenario/nominal_motion.h"
#include "sim/verdict/path_line.h"
#include "sim/world/world.h"

namespace sidestep {

/// One period of a gait (s): every foot has stepped once. A stand, which has none, counts as 1 s.
/// @param num_feet  Of the robot; a run alternates them, a hop uses all at once.
double GaitCycle_s(const GaitParams& gait, std::size_t num_feet);

/// The CoM against its path at one tick. Horizontal.
struct PathSample {
  Tick tick{0};
  double error_m{0.0};    ///< Length of the offset from the path line.
  double drift_m{0.0};    ///< Length of the mean offset.
  double wander_m{0.0};   ///< Length of the offset less the mean offset.
  double speed_mps{0.0};  ///< Length of the mean velocity.
  /// Length of the mean velocity less the nominal one over the same time.
  double speed_error_mps{0.0};
  /// Length of the mean velocity less the nominal one where the robot is on the line, whenever the
  /// gait was to be there; both over the gait cycle of that place.
  double pace_error_mps{0.0};
};

class PathMeter {
 public:
  /// @param nominal  Of the same gait. @param rate_hz  Of the samples.
  PathMeter(const NominalMotion& nominal, const AskedGait& asked, double rate_hz);

  /// Whether samples are taken at `tick`: at the meter's rate, from tick 0 on.
  bool Samples(Tick tick) const { return tick % period_ == 0; }

  /// Takes a tick that it samples; these follow each other without a gap.
  const PathSample& Add(Tick tick, const WorldTruth& truth);

  /// The latest sample; NaN without any, but for the tick.
  const PathSample& last() const { return last_; }

  double max_error_m() const { return max_error_m_; }  ///< Of all samples; NaN without any.

 private:
  static constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

  struct Past {
    Eigen::Vector2d p_WC;
    Eigen::Vector2d offset_sum_m;  // of all samples up to this one
  };

  std::size_t CycleSamples(double tick) const;
  void MeasureOffset(const Eigen::Vector2d& offset_m, std::size_t cycle);
  void MeasureSpeed(const WorldTruth& truth, std::size_t cycle);
  void MeasurePace(const WorldTruth& truth);
  Eigen::Vector2d MeanVelocity_mps(const WorldTruth& truth, std::size_t back) const;
  Eigen::Vector2d NominalVelocity_mps(double end_tick, std::size_t back) const;

  double tick_s_;
  Tick period_;  // between samples
  std::vector<GaitParams> gait_;
  std::size_t num_feet_;
  PathLine line_;
  std::vector<Past> past_;
  double on_line_tick_{0.0};  // when the nominal CoM is where the robot was on the line last
  PathSample last_{0, kNaN, kNaN, kNaN, kNaN, kNaN, kNaN};
  double max_error_m_{kNaN};
};

}  // namespace sidestep
