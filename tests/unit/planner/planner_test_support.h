// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// planner_test_support: gaits of one and two feet at ticks of 1 ms, and who stands when in them.

#include <vector>

#include "controller/planner/gait_generator.h"
#include "controller/planner/nominal_gait.h"

namespace sidestep {

inline constexpr double kTick_s = 0.001;
inline constexpr double kSoleHeight_m = 0.015;
inline constexpr double kComHeight_m = 0.5;

inline GaitGeometry Geometry(int num_feet) {
  return {num_feet, kComHeight_m, kSoleHeight_m, {-0.1, -0.05, -0.01}, {0.2, 0.15, 0.02}, {}};
}

inline GaitParams Stretch(GaitType type, double start_s) {
  GaitParams gait;
  gait.type = type;
  gait.start_s = start_s;
  gait.step_width_m = type == GaitType::kHop ? 0.0 : 0.16;
  gait.step_length_m = type == GaitType::kStand ? 0.0 : 0.1;
  gait.swing_s = 0.6;
  gait.double_support_s = 0.2;
  gait.stance_s = 0.25;
  gait.flight_s = 0.15;
  return gait;
}

inline GaitSetup SetupOf(const std::vector<GaitParams>& segments, int num_feet) {
  return {segments, Geometry(num_feet), kTick_s};
}

/// The support that `tick` lies in, of a gait that nothing disturbs.
inline GaitSupport SupportAt(const GaitSetup& setup, Tick tick) {
  GaitSupport support = StandingSupport(setup);
  for (auto next = NextSupport(setup, support); next && next->tick <= tick;) {
    support = *next;
    next = NextSupport(setup, support);
  }
  return support;
}

/// The contact that `foot` stands in at `tick`, or null.
inline const NominalContact* ContactAt(const NominalGait& gait, std::size_t foot, Tick tick) {
  for (const NominalContact& nominal : gait.feet[foot]) {
    const PlannedContact& contact = nominal.contact;
    const bool has_ended = contact.end_is_known && contact.end_tick <= tick;
    if (contact.start_tick <= tick && !has_ended) return &nominal;
  }
  return nullptr;
}

inline int FeetDown(const NominalGait& gait, Tick tick) {
  int down = 0;
  for (std::size_t foot = 0; foot < gait.feet.size(); ++foot) {
    down += ContactAt(gait, foot, tick) != nullptr ? 1 : 0;
  }
  return down;
}

/// A stretch of time with the same number of feet down.
struct Support {
  int feet{0};
  Tick ticks{0};
};

/// The supports that begin and end within [start, end).
inline std::vector<Support> Supports(const NominalGait& gait, Tick start, Tick end) {
  std::vector<Support> supports;
  for (Tick tick = start; tick < end; ++tick) {
    const int feet = FeetDown(gait, tick);
    if (supports.empty() || supports.back().feet != feet) supports.push_back({feet, 0});
    ++supports.back().ticks;
  }
  supports.erase(supports.begin());
  if (!supports.empty()) supports.pop_back();
  return supports;
}

}  // namespace sidestep
