// SPDX-License-Identifier: BSD-3-Clause
// When and from where pushes come.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/limit/push_limit.h"

namespace sidestep::limit {
namespace {

constexpr double kBeforeLanding_s = 0.05;

// "50%", "12.5%".
std::string PercentName(double share) {
  const double percent = std::round(1000.0 * share) / 10.0;
  std::string name = std::to_string(percent);
  name.resize(name.find('.') + (percent == std::round(percent) ? 0 : 2));
  return name + "%";
}

}  // namespace

std::vector<PushMoment> EvenMoments(const LimitParams& params, GaitType gait, int count) {
  if (gait == GaitType::kStand) return {{"standing", 0.0}};
  const double step_s = gait == GaitType::kHop ? params.stance_s + params.flight_s
                                               : params.swing_s + params.double_support_s;
  std::vector<PushMoment> moments;
  for (int i = 0; i < count; ++i) {
    const double share = static_cast<double>(i) / count;
    moments.push_back({PercentName(share), step_s * share});
  }
  return moments;
}

std::vector<PushMoment> NamedMoments(const LimitParams& params, GaitType gait) {
  if (gait == GaitType::kStand) return EvenMoments(params, gait, 1);
  if (gait == GaitType::kHop) {
    return {{"touch_down", 0.0},
            {"mid_stance", 0.5 * params.stance_s},
            {"lift_off", params.stance_s},
            {"mid_flight", params.stance_s + 0.5 * params.flight_s}};
  }
  std::vector<PushMoment> moments{
      {"lift_off", 0.0},
      {"mid_swing", 0.5 * params.swing_s},
      {"before_landing", std::max(0.0, params.swing_s - kBeforeLanding_s)}};
  if (params.double_support_s > 0.0) {
    moments.push_back({"double_support", params.swing_s + 0.5 * params.double_support_s});
  }
  return moments;
}

std::vector<double> EvenDirections(int count, bool is_planar) {
  if (is_planar) return {0.0, std::numbers::pi};
  std::vector<double> directions_rad;
  for (int i = 0; i < count; ++i) directions_rad.push_back(2.0 * std::numbers::pi * i / count);
  return directions_rad;
}

}  // namespace sidestep::limit
