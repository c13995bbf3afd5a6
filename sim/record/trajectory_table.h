// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// trajectory_table: the columns of trajectory.csv.
//
// One walk over the columns writes both the header and the rows, so that they can't disagree.
// What a controller does not say is an empty cell: without feet in its state it believes nothing,
// without feet among its targets it plans nothing (and its plan has no age); without either it
// tells nothing of its whole body.
//
// A table of full detail writes every number with the fewest digits that read back as the same
// double, one of normal detail to its column's resolution; time_s is never rounded.

#include <string>
#include <string_view>
#include <vector>

#include "controller/types/control_tick.h"
#include "sim/record/log_detail.h"
#include "sim/record/tick_times.h"
#include "sim/scenario/scenario.h"
#include "sim/world/world.h"

namespace sidestep {

/// What one row shows.
struct TrajectoryRow {
  double time_s;  ///< Simulated.
  const WorldTruth& truth;
  const ControlTick& control;  ///< Of the same tick; both are referred to, not copied.
  TickTimes times;
};

/// The columns are fixed by the constructor: feet and joints by name, and whether a joint's command
/// is a torque or a reference. Names end in their unit, as keys do.
class TrajectoryTable {
 public:
  /// @param robot  The nominal one. @param mode  Whose commands are told. @param joints  Of the
  /// plant. @param detail  How its numbers are written.
  TrajectoryTable(const RobotDescription& robot, Plant plant, ControlMode mode,
                  std::vector<JointInfo> joints, LogDetail detail = LogDetail::kFull);

  /// The first line, with its end.
  std::string Header() const;

  /// Appends the row's line to `text`. Preconditions: truth has this table's feet and joints.
  void AppendRow(const TrajectoryRow& row, std::string& text) const;

 private:
  class Line;
  std::vector<std::string> Columns() const;
  /// Every column in order, which is the file's. The others are its parts.
  void Walk(const TrajectoryRow& row, Line& line) const;
  void WalkTruth(const WorldTruth& truth, Line& line) const;
  void WalkBelief(const ControlTick& control, Line& line) const;
  void WalkPlan(const ControlTick& control, Line& line) const;
  void WalkJoints(const TrajectoryRow& row, Line& line) const;

  std::vector<std::string> feet_;  ///< Names.
  std::vector<JointInfo> joints_;
  bool has_references_;        ///< Commands are references of servos.
  Eigen::Vector3d up_B_;       ///< Of B's upright.
  std::vector<int> decimals_;  ///< Of each column; empty: all digits.
};

}  // namespace sidestep
