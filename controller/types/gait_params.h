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
  double start_s{0.0};
  double step_length_m{0.0};
  double step_width_m{0.16};
  double swing_s{0.6};
  double double_support_s{0.2};
  double stance_s{0.2};
  double flight_s{0.2};
  double swing_height_m{0.05};
  double landing_speed_mps{0.3};
  double step_side_m{0.0};

  template <typename Self, typename Visitor>
  static void VisitFields(Self& self, Visitor&& visit) {
    visit("type", self.type, "stand, walk or run (two feet), hop (one foot)");
    visit("start_s", self.start_s, Range{0.0, 1e4},
          "this gait begins at the first touch-down from here on; the first gait starts at 0");
    visit("step_length_m", self.step_length_m, Range{-1.0, 1.0},
          "advance along x from one touch-down to the next");
    visit("step_width_m", self.step_width_m, Range{0.0, 1.0},
          "distance of the feet along y; of a robot of one foot it is 0");
    visit("swing_s", self.swing_s, Range{0.05, 5.0}, "walk: a foot's time in the air");
    visit("double_support_s", self.double_support_s, Range{0.0, 5.0},
          "walk: time with both feet on the ground, once a step");
    visit("stance_s", self.stance_s, Range{0.02, 5.0}, "run, hop: a foot's time on the ground");
    visit("flight_s", self.flight_s, Range{0.0, 2.0},
          "run, hop: time with no foot on the ground, once a step");
    visit("swing_height_m", self.swing_height_m, Range{0.0, 0.5},
          "greatest height of a swinging sole above the ground");
    visit("landing_speed_mps", self.landing_speed_mps, Range{0.0, 2.0},
          "downward speed of a foot at touch-down, and after it until contact is felt");
    visit("step_side_m", self.step_side_m, Range{-0.5, 0.5},
          "advance along y (to the left) from one touch-down to the next");
  }
};

/// Where nominal footholds go once the robot was pushed off its path.
enum class FollowMode {
  kPath,         ///< They stay where the gait puts them.
  kCapturePoint  ///< They move with the capture point at each landing, then drift back.
};

template <>
struct EnumNames<FollowMode> {
  static constexpr std::array<std::pair<FollowMode, std::string_view>, 2> kNames{
      {{FollowMode::kPath, "path"}, {FollowMode::kCapturePoint, "capture_point"}}};
};

struct PlannerParams {
  FollowMode follow{FollowMode::kPath};
  double path_return_m{0.05};
  double min_step_width_m{0.0};
  double com_sway{0.0};

  template <typename Self, typename Visitor>
  static void VisitFields(Self& self, Visitor&& visit) {
    visit("follow", self.follow,
          "where nominal footholds go once the robot is off its path: path: they stay on it; "
          "capture_point: they move with the capture point at each landing, then drift back");
    visit("path_return_m", self.path_return_m, Range{0.0, 1.0},
          "largest drift back to the path in one step, once off it");
    visit("min_step_width_m", self.min_step_width_m, Range{0.0, 1.0},
          "of two feet: least distance along y that a step adjustment may leave");
    visit("com_sway", self.com_sway, Range{0.0, 1.0},
          "where the CoM reference is in the middle of a swing: this share of the way from the "
          "path to the standing foot (0, as in the paper: on the path)");
  }
};

}  // namespace sidestep
