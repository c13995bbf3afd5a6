// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// flight_meter: how high the CoM rises while no foot stands, against its nominal motion.

#include <limits>

#include "sim/world/world.h"

namespace sidestep {

/// A flight is a time of at least 50 ms without contact of any foot. Its error is the CoM's largest
/// height in it less the nominal CoM's largest height in it.
class FlightMeter {
 public:
  explicit FlightMeter(double tick_s) : tick_s_(tick_s) {}

  /// Takes one tick. @param nominal_height_m  Of the nominal CoM at the same tick.
  void Add(const WorldTruth& truth, double nominal_height_m);

  /// Largest absolute error of the flights that have ended (m); NaN if there was none.
  double max_apex_error_m() const { return max_apex_error_m_; }

 private:
  static constexpr double kLowest_m = -std::numeric_limits<double>::infinity();

  double tick_s_;
  int num_ticks_{0};          ///< Of the flight under way.
  double apex_m_{kLowest_m};  ///< In it.
  double nominal_apex_m_{kLowest_m};
  double max_apex_error_m_{std::numeric_limits<double>::quiet_NaN()};
};

}  // namespace sidestep
