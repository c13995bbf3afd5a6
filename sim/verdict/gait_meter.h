// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// gait_meter: what a gait came to: speed, steps, stance, flight, work, by the truth alone.
//
// Figures are told for each gait that the scenario asks for, over its whole strides. A stride goes
// from a foot's touch-down to its next one; the foot is the one that steps first in the gait. A
// gait begins with the first step that comes down from its start_s on, and the gait before ends
// with it: by the clock, so that a robot that is late makes its last steps of a gait in the next
// one's time. What comes before the first touch-down and after the last whole stride counts
// nowhere, pushes in between do. A step is one that StepLog tells. A foot is in stance while it
// bears load, 5 % of the weight; a break of 10 ms or less belongs to the stance, as StanceMeter has
// it. The robot flies while no foot is in stance, from the first tick on at which one has been.
//
// What a tick was is known later: whether the foot comes back within 10 ms, whether a touch-down
// was a step after kShortestStance_s. So ticks wait that long before they count.

#include <Eigen/Core>
#include <cstddef>
#include <deque>
#include <optional>
#include <span>
#include <vector>

#include "controller/types/gait_params.h"
#include "controller/types/tick.h"
#include "sim/verdict/stance_meter.h"
#include "sim/verdict/step_log.h"
#include "sim/verdict/verdict.h"
#include "sim/world/world.h"

namespace sidestep {

/// The plant's own facts that the figures are told by.
struct GaitPlant {
  std::size_t num_feet{1};
  double mass_kg{0.0};     ///< > 0.
  bool has_motors{false};  ///< Without, nothing does work.
};

class GaitMeter {
 public:
  /// @param segments  In order of start_s. @param tick_s  Length of a tick.
  GaitMeter(const std::vector<GaitParams>& segments, const GaitPlant& plant, double tick_s);

  /// Takes one tick. @param stances  One a foot, having seen it. @param touch_downs  Those that
  /// StepLog told at this tick.
  void Add(Tick tick, const WorldTruth& truth, const std::vector<StanceMeter>& stances,
           std::span<const TouchDown> touch_downs);

  /// One a segment, in their order.
  std::vector<GaitRecord> Records() const;

  /// Of the last segment that is no stand; without whole strides, or if all stand, nothing is
  /// measured.
  GaitFigures LastMoving() const;

  /// Share of the time of all walks, and not only of their whole strides, in which no foot was in
  /// stance; NaN without a walk. A walk lasts until the next gait begins.
  double WalkFlightFraction() const;

  /// The same of all whole strides of gaits that run or hop.
  double RunFlightFraction() const;

 private:
  /// Sums from the first tick to a touch-down, and where the robot was then.
  struct Mark {
    Tick tick{0};
    Eigen::Vector2d p_WC{Eigen::Vector2d::Zero()};
    Eigen::Vector2d p_WF{Eigen::Vector2d::Zero()};  ///< Of the foot that came down.
    int steps{0};
    double stance_s{0.0};  ///< Of all feet together.
    double flight_s{0.0};
    double work_J{0.0};
  };

  /// What a tick showed.
  struct Instant {
    Tick tick;
    std::vector<bool> in_stance;  ///< One a foot.
    Eigen::Vector2d p_WC;
    double power_W;      ///< Positive mechanical power of the joints.
    double max_force_N;  ///< Largest vertical one on a foot.
  };

  struct Segment {
    GaitParams gait;
    std::optional<std::size_t> foot;  ///< That strides are counted by.
    Mark first, last;
    int strides{0};
    double max_force_N{0.0};  ///< In them.
    double duration_s{0.0};   ///< So far, from its begin.
    double flight_s{0.0};     ///< In that.
  };

  /// All ticks so far, as if nothing more came.
  GaitMeter Settled() const;
  void BridgeBreak(std::size_t foot);
  void Settle(const Instant& instant);
  void Integrate(const Instant& instant);
  std::size_t SegmentAt(Tick tick) const;
  void NoteStep(const TouchDown& touch_down);
  /// If it is the segment's foot that came down.
  void CloseStride(std::size_t foot, const Mark& mark, Segment& segment) const;
  GaitFigures FiguresOf(const Segment& segment) const;

  static Instant InstantOf(Tick tick, const WorldTruth& truth,
                           const std::vector<StanceMeter>& stances);

  std::vector<Segment> segments_;
  std::size_t begun_{0};  // the segment under way
  GaitPlant plant_;
  double tick_s_;
  std::deque<Instant> recent_;       // that wait, the oldest first
  std::deque<TouchDown> steps_;      // likewise
  std::optional<Instant> last_;      // that has counted
  Mark sums_;                        // up to it
  std::vector<double> max_force_N_;  // on any foot, since each foot's last step
};

}  // namespace sidestep
