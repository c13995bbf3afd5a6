// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// gait_params: the nominal gait and how it follows a robot that was pushed off its path.

#include <array>
#include <string_view>
#include <utility>

#include "controller/types/field.h"

namespace sidestep {

enum class GaitType { kStand, kWalk, kRun, kHop };

template <>
struct EnumNames<GaitType> {
  static constexpr std::array<std::pair<GaitType, std::string_view>, 4> kNames{
      {{GaitType::kStand, "stand"},
       {GaitType::kWalk, "walk"},
       {GaitType::kRun, "run"},
       {GaitType::kHop, "hop"}}};
};

/// One stretch of the nominal gait, from start_s to the next stretch's start.
struct GaitParams {
  GaitType type{GaitType::kStand};
  double start_s{0.0};            ///< The gait changes at the first touch-down from here on.
  double step_length_m{0.0};      ///< Advance along x from one touch-down to the next.
  double step_width_m{0.16};      ///< Distance of the feet along y; 0 for one foot.
  double swing_s{0.6};            ///< walk: a foot's time in the air.
  double double_support_s{0.2};   ///< walk: both feet on the ground, once a step.
  double stance_s{0.2};           ///< run, hop: a foot's time on the ground.
  double flight_s{0.2};           ///< run, hop: no foot on the ground, once a step.
  double swing_height_m{0.05};    ///< Apex of the sole above the ground.
  double landing_speed_mps{0.3};  ///< Downward, at touch-down and after it until contact is felt.
  double step_side_m{0.0};        ///< Advance along y (left) from one touch-down to the next.

  template <typename Self, typename Visitor>
  static void VisitFields(Self& self, Visitor&& visit) {
    visit("type", self.type);
    visit("start_s", self.start_s, Range{0.0, 1e4});
    visit("step_length_m", self.step_length_m, Range{-1.0, 1.0});
    visit("step_width_m", self.step_width_m, Range{0.0, 1.0});
    visit("swing_s", self.swing_s, Range{0.05, 5.0});
    visit("double_support_s", self.double_support_s, Range{0.0, 5.0});
    visit("stance_s", self.stance_s, Range{0.02, 5.0});
    visit("flight_s", self.flight_s, Range{0.0, 2.0});
    visit("swing_height_m", self.swing_height_m, Range{0.0, 0.5});
    visit("landing_speed_mps", self.landing_speed_mps, Range{0.0, 2.0});
    visit("step_side_m", self.step_side_m, Range{-0.5, 0.5});
  }
};

/// Where nominal footholds go once the robot was pushed off its path.
enum class FollowMode {
  kPath,         ///< They stay where the gait put them, or where a recovery led.
  kCapturePoint  ///< They move with the capture point at each landing, then drift back.
};

template <>
struct EnumNames<FollowMode> {
  static constexpr std::array<std::pair<FollowMode, std::string_view>, 2> kNames{
      {{FollowMode::kPath, "path"}, {FollowMode::kCapturePoint, "capture_point"}}};
};

/// Steps that the gait does not have, taken when the feet can no longer hold the robot.
struct RecoveryParams {
  bool enabled{false};
  double margin_m{0.02};  ///< How near the capture point may come to the edge of the soles.
  double swing_s{0.4};
  double double_support_s{0.1};
  int steps{3};  ///< Before the gait goes on.

  template <typename Self, typename Visitor>
  static void VisitFields(Self& self, Visitor&& visit) {
    visit("enabled", self.enabled);
    visit("margin_m", self.margin_m, Range{-0.5, 0.5});
    visit("swing_s", self.swing_s, Range{0.05, 5.0});
    visit("double_support_s", self.double_support_s, Range{0.0, 5.0});
    visit("steps", self.steps, Range{1.0, 20.0});
  }
};

struct PlannerParams {
  FollowMode follow{FollowMode::kPath};
  double path_return_m{0.05};    ///< Largest drift back to the path in one step, once off it.
  double min_step_width_m{0.0};  ///< Of two feet: what no step adjustment may go below.
  /// CoM reference in the middle of a walk's swing: this share of the way from the path to the foot
  /// that stands. 0 as in the paper, whose reference stays on the path.
  double com_sway{0.0};
  RecoveryParams recovery;

  template <typename Self, typename Visitor>
  static void VisitFields(Self& self, Visitor&& visit) {
    visit("follow", self.follow);
    visit("path_return_m", self.path_return_m, Range{0.0, 1.0});
    visit("min_step_width_m", self.min_step_width_m, Range{0.0, 1.0});
    visit("com_sway", self.com_sway, Range{0.0, 1.0});
    visit("recovery", self.recovery);
  }
};

}  // namespace sidestep
