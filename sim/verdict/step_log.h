// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// step_log: where and when the feet came down in truth, and the swings before.
//
// A foot has stepped when it stands again after a swing: at least 50 ms off the ground, in which it
// rose by 5 mm or moved by 1 cm horizontally. Less is rocking. And its stance, as StanceMeter has
// it, must still be under way 50 ms after the touch-down, which is when the step is told: a foot
// that scuffs the ground on its way swings on.
//
// The adjustment of a step needs no controller: it is the step that was taken less the nominal one,
// horizontally. A step goes from where the other foot stands, or stood last, to the touch-down;
// with a single foot from where that stood last. So a robot that has drifted off its path pays for
// no step but the one that it takes elsewhere. The gait's step is that to the foot's contact
// nearest in time. A touch-down more than 0.1 s from that contact's start may as well have made the
// contact on its other side, and is compared with the nearer of both steps: a robot whose schedule
// is late by more than half a stride makes its last whole step when the gait closes its feet, and
// pays nothing for it. One that is late by whole strides looks as if it were on time, and does.

#include <Eigen/Core>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "controller/types/tick.h"
#include "models/robot_description/robot_description.h"
#include "sim/scenario/nominal_motion.h"
#include "sim/scenario/world_params.h"
#include "sim/verdict/stance_meter.h"
#include "sim/world/world.h"

namespace sidestep {

/// The stance of a step is under way as long after its touch-down (s).
constexpr double kShortestStance_s = 0.05;

/// A foot that came down to stand.
struct TouchDown {
  std::size_t foot{0};
  bool is_step{false};                            ///< It ended a swing; else a stance of the start.
  Tick tick{0};                                   ///< First tick that it bears load.
  Tick end_tick{0};                               ///< First tick after its last contact so far.
  Eigen::Vector3d p_WF{Eigen::Vector3d::Zero()};  ///< At `tick`.
  double slip_m{0.0};  ///< Farthest slide until the foot steps again; see SlipMeter.
  /// Horizontal length of step taken less nominal step (m); empty for the stance of the start, and
  /// where there was no stance to step from.
  std::optional<double> adjustment_m;
};

class StepLog {
 public:
  /// @param feet  The robot's, in the order of every other vector of feet. @param tick_s  Length of
  /// a tick. @param ground  Of the world; heights of soles count from what lies below the foot.
  StepLog(const std::vector<FootDescription>& feet, double tick_s,
          std::vector<GroundPatch> ground = {});

  /// Takes one tick. @param stances  One a foot, having seen it. @param stance_slip_m  Likewise, as
  /// SlipMeter tells. @param nominal  Of the same robot.
  void Add(Tick tick, const WorldTruth& truth, const std::vector<StanceMeter>& stances,
           const std::vector<double>& stance_slip_m, const NominalMotion& nominal);

  /// So far, each foot's in order of time; a step appears kShortestStance_s after its tick. The
  /// first of each foot is the stance of the start, unless the foot began in the air as it would in
  /// a swing.
  const std::vector<TouchDown>& touch_downs() const { return touch_downs_; }

  /// Adjustments (m) of the steps that came down at or after `from`.
  std::vector<double> AdjustmentsFrom(Tick from) const;

  /// Smallest apex of the sole's lowest corner above the ground over the finished swings (m); NaN
  /// if there was none.
  double min_swing_clearance_m() const;

 private:
  static constexpr double kLowest_m = -std::numeric_limits<double>::infinity();

  // A step, if its stance lasts; until then the foot's own figures are those of the swing.
  struct YoungStep {
    TouchDown touch_down;
    std::optional<Eigen::Vector3d> from_p_WF;              // where it steps from
    Eigen::Vector3d stance_p_WF{Eigen::Vector3d::Zero()};  // where it bore load last
  };

  struct Foot {
    FootDescription description;
    int num_stances{0};
    Tick last_contact_tick{0};                   // of a stance; before any, of the first tick
    std::optional<Eigen::Vector3d> stance_p_WF;  // where it bore load last
    std::optional<std::size_t> touch_down;       // its latest
    std::optional<YoungStep> young;
    double apex_m{kLowest_m};  // since it was last on the ground to stand
  };

  void NoteTouchDown(Tick tick, std::size_t foot, const FootTruth& truth);
  void Follow(Tick tick, Foot& foot, const FootTruth& truth, const StanceMeter& stance,
              double slip_m);
  void FollowYoung(Tick tick, Foot& foot, const FootTruth& truth, const StanceMeter& stance,
                   double slip_m);
  void Confirm(std::size_t foot, const NominalMotion& nominal);
  void DropScuff(Foot& foot);
  bool HasSwung(Tick tick, const Foot& foot, const FootTruth& truth) const;
  std::optional<double> Adjustment_m(std::size_t foot, const YoungStep& young,
                                     const NominalMotion& nominal) const;

  double tick_s_;
  std::vector<GroundPatch> ground_;
  std::vector<Foot> feet_;
  std::vector<TouchDown> touch_downs_;
  double min_swing_clearance_m_{std::numeric_limits<double>::infinity()};
};

}  // namespace sidestep
