// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// push_meter: what every push did to the robot, and whether and when it recovered.
//
// RECOVERED, one definition for every robot, plant and controller. A robot has recovered from a
// push at the first time from the push's end on from which for 1 s
//   (a) its CoM is within 0.05 m of its nominal path, horizontally, once the drift is taken off:
//       the mean of its offset from the path over the last gait cycle. One that was moved aside and
//       walks on there has recovered; how far aside is a figure of its own, `drift_m`.
//   (b) its mean horizontal velocity over the last gait cycle is within 0.1 m/s of the nominal one
//       where it is on the path, or is itself below 0.1 m/s: it goes on, or stands still.
//   (c) its base is within 0.2 rad of its attitude at the start (a walk of the iCub sways by 0.17).
// The second must be over before the next push begins and before the run ends, and the robot must
// not fall before the next push. The path is a line, not a timetable: see path_meter.h.
//
// A push's window lasts from its start to the start of the next one, or to the end of the run.
// Pushes at most 1 s apart leave no time to recover between them: they count as one, from the
// first one's start to the last one's end, and share their figures.

#include <limits>
#include <optional>
#include <vector>

#include "controller/types/tick.h"
#include "sim/scenario/push.h"
#include "sim/verdict/path_meter.h"
#include "sim/verdict/verdict.h"

namespace sidestep {

class PushMeter {
 public:
  PushMeter(const std::vector<Push>& pushes, double tick_s);

  /// Other pushes instead of those it has; none of either may have started.
  void ReplacePushes(const std::vector<Push>& pushes);

  /// Takes the tilt of every tick, in order; see FallMeter.
  void AddTilt(Tick tick, double tilt_rad);

  /// Takes a sample of the path, after the tilt of the same tick.
  void AddPath(const PathSample& sample);

  /// Takes a step that came down. @param adjustment_m  See TouchDown; empty if there is none to
  /// tell.
  void AddStep(Tick tick, std::optional<double> adjustment_m);

  /// Whether (a), (b) and (c) hold at the latest sample; false before the first.
  bool is_calm() const { return is_calm_; }

  /// The robot fell. Has a meaning once.
  void AddFall(Tick tick);

  /// Figures of push number `push`, in the scenario's order.
  const PushFigures& figures(std::size_t push) const;

  /// Longest recovery; infinite if one never came, NaN without a push (s).
  double worst_recovery_time_s() const;

  /// Every push was recovered from; true without any.
  bool all_recovered() const;

 private:
  struct Disturbance {
    Tick start{0};
    Tick end{0};
    Tick window_end{std::numeric_limits<Tick>::max()};
    PushFigures figures;
    std::optional<Tick> calm_since;
  };

  Disturbance* At(Tick tick);

  double tick_s_;
  double tilt_rad_{0.0};  // of the last tick
  bool has_fallen_{false};
  bool is_calm_{false};                    // at the last sample
  std::vector<Disturbance> disturbances_;  // by time, no two windows overlap
  std::vector<std::size_t> disturbance_of_push_;
};

}  // namespace sidestep
