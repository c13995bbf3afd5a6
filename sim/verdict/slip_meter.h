// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// slip_meter: how far one foot slides while it stands.

#include <Eigen/Core>
#include <optional>

#include "controller/types/tick.h"
#include "sim/world/world.h"

namespace sidestep {

/// Measures one foot. A stance begins when the plan has the foot stand and it does; a bounce of up
/// to 10 ms does not end it.
/// The foot's place at the first loaded tick from 10 ms on is its anchor: a landing may settle. The
/// slide is the horizontal distance from the anchor while the foot is loaded: once the
/// force has all but vanished before lift-off, moving is no slipping.
class SlipMeter {
 public:
  /// @param tick_s  Length of a tick. @param min_load_N  Vertical force of a loaded foot.
  SlipMeter(double tick_s, double min_load_N);

  /// @param planned_contact  Whether the foot is meant to stand.
  void Add(Tick tick, const FootTruth& foot, bool planned_contact);

  /// Farthest slide of the stance so far (m); 0 in the air.
  double stance_slip_m() const { return stance_slip_m_; }

  /// Farthest slide of any stance so far (m).
  double max_slip_m() const { return max_slip_m_; }

 private:
  double tick_s_;
  double min_load_N_;
  std::optional<Tick> stance_start_tick_;
  Tick last_contact_tick_{0};
  std::optional<Eigen::Vector2d> anchor_W_;
  double stance_slip_m_{0.0};
  double max_slip_m_{0.0};
};

}  // namespace sidestep
