// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// sole_meter: how flat the feet stand.

#include <Eigen/Core>
#include <limits>
#include <vector>

#include "models/robot_description/robot_description.h"
#include "sim/world/world.h"

namespace sidestep {

/// Height of the sole's lowest corner over where it is when the foot stands level (m). A sole that
/// stands on the ground, level, is at 0.
double SoleHeight_m(const FootDescription& foot, const FootTruth& truth);

/// Watches the feet that have a sole: three corners and more.
class SoleMeter {
 public:
  /// @param min_load_N  Vertical force of a foot that carries.
  SoleMeter(const std::vector<FootDescription>& feet, double min_load_N);

  /// Takes one tick. @param planned_contact  One a foot.
  void Add(const WorldTruth& truth, const std::vector<bool>& planned_contact);

  /// Largest angle between the vertical and a sole's normal while its foot was meant to stand and
  /// carried (rad); NaN if none did.
  double max_tilt_rad() const { return max_tilt_rad_; }

 private:
  std::vector<bool> has_sole_;
  double min_load_N_;
  double max_tilt_rad_{std::numeric_limits<double>::quiet_NaN()};
};

}  // namespace sidestep
