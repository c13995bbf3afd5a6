// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// gait_params: the nominal gait and how it follows a robot that was pushed off its path.

#include <array>
#include <string_view>
#include <utility>

#include "controller/types/field.h"
#include "controller/types/swing_limits.h"

namespace sidestep {

/// What the feet do. Each kind reads its own times of GaitParams and leaves the others alone.
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
/// A step lasts swing_s + double_support_s of a walk, stance_s + flight_s of a run or hop; each
/// touch-down lies (step_length_m, step_side_m) farther along the path than the one before, in W.
/// Each time becomes whole ticks where it is used.
/// Ranges are all that is checked here: sim/scenario/check_scenario refuses a kind that the robot
/// has not the feet for, and gaits that are out of order.
struct GaitParams {
  GaitType type{GaitType::kStand};  ///< Decides which of the times below count.
  double start_s{0.0};              ///< The gait before ends with a touch-down.
  double step_length_m{0.0};        ///< 0: on the spot; below 0: backwards.
  double step_width_m{0.16};        ///< Of the nominal footholds: the MPC may narrow it.
  double swing_s{0.6};              ///< Walk alone.
  double double_support_s{0.2};     ///< Walk alone; 0: one foot leaves as the other lands.
  double stance_s{0.2};             ///< Run and hop; never below kShortestStep_s.
  double flight_s{0.2};             ///< Run and hop; 0: a run without flight.
  double swing_height_m{0.05};      ///< Above the higher of the two footholds.
  double landing_speed_mps{0.3};    ///< So that a floor lower than believed is found.
  double step_side_m{0.0};          ///< 0: straight ahead.

  template <typename Self, typename Visitor>
  static void VisitFields(Self& self, Visitor&& visit) {
    visit("type", self.type, "stand, walk or run (two feet), hop (one foot)");
    visit("start_s", self.start_s, Range{0.0, 1e4},
          "this gait begins at the first touch-down from here on; the first gait starts at 0");
    visit("step_length_m", self.step_length_m, Range{-1.0, 1.0},
          "advance along x from one touch-down to the next");
    visit("step_width_m", self.step_width_m, Range{0.0, 1.0},
          "distance of the feet along y; of one foot 0, of a robot in a plane what it has");
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

/// When a walk that is pushed steps, and with which foot, if that is not for the clock alone.
/// A push is noticed by what the plan did not foresee (push_alarm.h). While that counts, and the
/// capture point is farther than error_m from where the gait would have it, other courses of the
/// next steps (planner/timing_candidates.h) are weighed by the MPC's cost against going on.
struct TimingParams {
  double error_m{0.0};  ///< 0: the clock decides. Above what a walk shows unpushed.
  double alert_s{1.0};  ///< Two steps and more.
  double gain{0.3};     ///< Against steps to and fro about nothing.
  double least_swing_s{0.25};
  double least_rest_s{0.1};
  double least_support_s{0.05};

  template <typename Self, typename Visitor>
  static void VisitFields(Self& self, Visitor&& visit) {
    visit("error_m", self.error_m, Range{0.0, 10.0},
          "a capture point that a push takes farther than this makes a walk choose when its feet "
          "land and lift off, and which (0: never)");
    visit("alert_s", self.alert_s, Range{0.0, 100.0}, "a push counts for so long");
    visit("gain", self.gain, Range{0.0, 1.0},
          "share of the MPC's cost that another course must save to be taken");
    visit("least_swing_s", self.least_swing_s, Range{0.05, 5.0},
          "shortest time in the air of a step that is still to begin");
    visit("least_rest_s", self.least_rest_s, Range{0.02, 5.0},
          "shortest time until a foot in the air lands");
    visit("least_support_s", self.least_support_s, Range{0.0, 5.0}, "shortest time on both feet");
  }
};

/// How far a walk's CoM reference goes to the side.
enum class SwayMode {
  kShare,    ///< As far as it is told.
  kPendulum  ///< As a linear pendulum over one foot after the other does.
};

template <>
struct EnumNames<SwayMode> {
  static constexpr std::array<std::pair<SwayMode, std::string_view>, 2> kNames{
      {{SwayMode::kShare, "share"}, {SwayMode::kPendulum, "pendulum"}}};
};

/// The way from the path to the standing foot, in the middle of a walk's swing. A pendulum whose
/// steps take T in all has its CoM at the share 1 - 1 / cosh(T / 2 sqrt(g / h)) of it; along that
/// reference the capture point is off by nothing as long as nobody pushes.
struct ComSway {
  SwayMode mode{SwayMode::kShare};
  double share{0.0};  ///< 1: over the standing foot. Of a pendulum the most, unless it is 0.
};

/// How the nominal path follows a robot that was pushed off it.
/// The MPC may only move a foothold within its box about the nominal one. With FollowMode::kPath
/// the boxes stay on the path, so that forces alone lead a robot back that left it by more than a
/// box. With kCapturePoint the nominal footholds move along, once a landing, and path_return_m says
/// how fast they come back. min_step_width_m and the box of MpcParams bound the same footholds:
/// KeepFeetApart() takes what the former forbids out of the latter.
struct PlannerParams {
  FollowMode follow{FollowMode::kPath};
  double path_return_m{0.05};    ///< Counts under kCapturePoint alone; 0: never back.
  double min_step_width_m{0.0};  ///< 0: feet may come in line, but not cross.
  ComSway sway;                  ///< Walk alone.
  double early_load_ratio{0.2};  ///< Of the weight; from the middle of the swing on.
  double late_wait_s{0.1};       ///< 0: the clock goes on without the foot.
  double search_depth_m{0.06};   ///< Below where it should be; time and reach may end it before.
  double search_acceleration_mps2{0.0};  ///< From landing_speed_mps on; 0: never faster.
  SwingLimits swing;                     ///< Of footholds and of the height in the air.
  TimingParams timing;

  template <typename Self, typename Visitor>
  static void VisitFields(Self& self, Visitor&& visit) {
    visit("follow", self.follow,
          "where nominal footholds go once the robot is off its path: path: they stay on it; "
          "capture_point: they move with the capture point at each landing, then drift back");
    visit("path_return_m", self.path_return_m, Range{0.0, 1.0},
          "largest drift back to the path in one step, once off it");
    visit("min_step_width_m", self.min_step_width_m, Range{0.0, 1.0},
          "of two feet: least distance along y that a step adjustment may leave");
    visit(
        "sway", self.sway.mode,
        "how far the CoM reference goes to the side: share: as com_sway has it; pendulum: as a "
        "linear pendulum that steps as the gait does, and no farther than com_sway unless that is "
        "0");
    visit("com_sway", self.sway.share, Range{0.0, 1.0},
          "where the CoM reference is in the middle of a swing: this share of the way from the "
          "path to the standing foot (0, as in the paper: on the path)");
    visit("early_load_ratio", self.early_load_ratio, Range{0.0, 1e3},
          "a swinging foot that bears more than this share of the weight has landed, and the "
          "schedule moves with it");
    visit("late_wait_s", self.late_wait_s, Range{0.0, 1.0},
          "longest time that the schedule waits for a foot that is due and not felt, and that "
          "the other foot puts its lift-off off while this one is not felt");
    visit("search_depth_m", self.search_depth_m, Range{0.0, 1.0},
          "how far below its foothold a foot that is due and not felt looks for the ground");
    visit("search_acceleration_mps2", self.search_acceleration_mps2, Range{0.0, 100.0},
          "how much faster it goes down the longer it looks, from landing_speed_mps on");
    visit("swing_speed_mps", self.swing.speed_mps, Range{0.0, 20.0},
          "a foot is sent no farther than this mean speed takes it by its landing (0: as far as "
          "the box goes)");
    visit("swing_acceleration_mps2", self.swing.acceleration_mps2, Range{0.0, 1000.0},
          "a foot is sent no farther and lifted no higher than this acceleration allows in the "
          "time that it has (0: as far and high as it is asked)");
    visit("timing", self.timing, "when a pushed walk lets its feet land and lift off");
  }
};

}  // namespace sidestep
