// SPDX-License-Identifier: BSD-3-Clause
#include "sim/verdict/flight_meter.h"

#include <algorithm>
#include <cmath>

namespace sidestep {
namespace {

constexpr double kShortest_s = 0.05;  // A lost contact of a step in passing is no flight.

}  // namespace

void FlightMeter::Add(const WorldTruth& truth, double nominal_height_m) {
  const bool is_flying = std::none_of(truth.feet.begin(), truth.feet.end(),
                                      [](const FootTruth& foot) { return foot.in_contact; });
  if (is_flying) {
    ++num_ticks_;
    apex_m_ = std::max(apex_m_, truth.p_WC.z());
    nominal_apex_m_ = std::max(nominal_apex_m_, nominal_height_m);
    return;
  }
  if (num_ticks_ * tick_s_ >= kShortest_s) {
    const double error_m = std::abs(apex_m_ - nominal_apex_m_);
    max_apex_error_m_ = std::fmax(max_apex_error_m_, error_m);  // fmax drops the first NaN
  }
  num_ticks_ = 0;
  apex_m_ = nominal_apex_m_ = kLowest_m;
}

}  // namespace sidestep
