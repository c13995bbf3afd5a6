// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// slip_meter: how far one foot slides while it stands.

#include <Eigen/Core>
#include <optional>

#include "sim/verdict/stance_meter.h"
#include "sim/world/world.h"

namespace sidestep {

/// Measures one foot, stance by stance as StanceMeter tells them. The foot's place at the first
/// settled, loaded tick of a stance is its anchor. The slide is the horizontal distance from the
/// anchor while the foot bears load: once the force has all but vanished before lift-off, moving is
/// no slipping. A foot that is dragged over the ground under load slips, planned there or not.
class SlipMeter {
 public:
  /// Takes one tick of the foot. @param stance  Of the same foot, having seen the same tick.
  void Add(const FootTruth& foot, const StanceMeter& stance);

  /// Farthest slide of the stance so far (m); 0 in the air.
  double stance_slip_m() const { return stance_slip_m_; }

  /// Farthest slide of any stance so far (m).
  double max_slip_m() const { return max_slip_m_; }

 private:
  int stance_{0};  // the number of the one that the anchor belongs to
  std::optional<Eigen::Vector2d> anchor_W_;
  double stance_slip_m_{0.0};
  double max_slip_m_{0.0};
};

}  // namespace sidestep
