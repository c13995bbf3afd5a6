// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// sole_meter: how flat the feet stand.

#include <Eigen/Core>
#include <limits>
#include <vector>

#include "models/robot_description/robot_description.h"
#include "sim/verdict/stance_meter.h"
#include "sim/world/world.h"

namespace sidestep {

/// Height of the sole's lowest corner over where it is when the foot stands level (m). A sole that
/// stands on the ground, level, is at 0.
double SoleHeight_m(const FootDescription& foot, const FootTruth& truth);

/// Watches the feet that have a sole: three corners and more.
class SoleMeter {
 public:
  explicit SoleMeter(const std::vector<FootDescription>& feet);

  /// Takes one tick. @param stances  One a foot, having seen the same tick.
  void Add(const WorldTruth& truth, const std::vector<StanceMeter>& stances);

  /// Largest angle between the vertical and a sole's normal while its foot stood, settled, and bore
  /// load (rad); NaN if none did. Toes or heel may touch first.
  double max_tilt_rad() const { return max_tilt_rad_; }

 private:
  std::vector<bool> has_sole_;
  double max_tilt_rad_{std::numeric_limits<double>::quiet_NaN()};
};

}  // namespace sidestep
