// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// limit_params: what the linear pendulum of `sidestep limit` has of a robot and its gait.

#include <array>
#include <string_view>
#include <utility>

#include "controller/types/field.h"

namespace sidestep::limit {

/// What a pushed pendulum may change of its steps.
enum class StepFreedom {
  kNone,    ///< Footholds and times are the gait's: only the centre of pressure moves.
  kPlaces,  ///< Footholds give way, times are the gait's.
  kFree     ///< Both give way; on two feet, either may step.
};

/// A robot as a linear pendulum on its soles, and the gait that it is in when it is pushed.
/// Lengths are of the ground's plane: x ahead, y from the standing foot's middle to the other foot.
/// LimitSubjectOf() fills it from a scenario; `--assume KEY=VALUE` replaces single values.
struct LimitParams {
  double omega_per_s{4.25};         ///< sqrt(g / h) of the CoM's height h.
  double sole_half_length_m{0.1};   ///< From the vertices of robot.yaml's foot.
  double sole_half_width_m{0.045};  ///< From them too.
  double cop_inset_m{0.0};          ///< From feet[].preferred_cop_m.
  double step_length_m{0.0};        ///< Of the gait.
  double step_width_m{0.16};        ///< Of the gait.
  double swing_s{0.4};              ///< Of the gait, if it is a walk.
  double double_support_s{0.1};     ///< Likewise.
  double stance_s{0.15};            ///< Of the gait, if it is a hop.
  double flight_s{0.15};            ///< Likewise.
  double reach_m{0.4};              ///< From the legs' lengths, else from the MPC's boxes.
  double nearest_m{0.11};           ///< From the soles' width, or the planner's least step width.
  double farthest_m{0.5};           ///< As reach_m.
  double crossing_m{0.0};           ///< Robots that ship do not cross.
  double swing_speed_mps{2.0};      ///< control.planner.swing_speed_mps.
  double least_swing_s{0.25};       ///< control.planner.timing.
  double least_rest_s{0.1};         ///< control.planner.timing.
  double least_support_s{0.05};     ///< control.planner.timing.
  double grid_m{0.01};              ///< Twice as coarse, they change by a twentieth at most.

  template <typename Self, typename Visitor>
  static void VisitFields(Self& self, Visitor&& visit) {
    visit("omega_per_s", self.omega_per_s, Range{0.5, 20.0}, "rate of the pendulum's fall");
    visit("sole_half_length_m", self.sole_half_length_m, Range{0.0, 1.0},
          "how far the centre of pressure gets from the sole's middle, ahead and back");
    visit("sole_half_width_m", self.sole_half_width_m, Range{0.0, 1.0}, "the same to each side");
    visit("cop_inset_m", self.cop_inset_m, Range{0.0, 0.5},
          "how far inside the sole's middle the gait has its centre of pressure");
    visit("step_length_m", self.step_length_m, Range{-1.0, 1.0}, "advance of the gait's step");
    visit("step_width_m", self.step_width_m, Range{0.0, 1.0}, "distance of the gait's feet");
    visit("swing_s", self.swing_s, Range{0.05, 5.0}, "a walk's time on one foot");
    visit("double_support_s", self.double_support_s, Range{0.0, 5.0}, "and on both, once a step");
    visit("stance_s", self.stance_s, Range{0.02, 5.0}, "a hop's time on the ground");
    visit("flight_s", self.flight_s, Range{0.0, 2.0}, "and in the air");
    visit("reach_m", self.reach_m, Range{0.0, 2.0},
          "farthest step, ahead and back; of a hop, farthest that the foot is from below the CoM");
    visit("nearest_m", self.nearest_m, Range{0.0, 1.0}, "nearest step to the side");
    visit("farthest_m", self.farthest_m, Range{0.0, 2.0}, "farthest step to the side");
    visit("crossing_m", self.crossing_m, Range{0.0, 2.0},
          "the first step may cross the standing foot where it is so far ahead or back (0: never)");
    visit("swing_speed_mps", self.swing_speed_mps, Range{0.01, 20.0},
          "mean speed of a foot in the air");
    visit("least_swing_s", self.least_swing_s, Range{0.05, 5.0}, "shortest swing");
    visit("least_rest_s", self.least_rest_s, Range{0.0, 5.0},
          "shortest time until a foot in the air lands");
    visit("least_support_s", self.least_support_s, Range{0.0, 5.0}, "shortest time on both feet");
    visit("grid_m", self.grid_m, Range{0.005, 0.1}, "distance of the footholds that are tried");
  }
};

}  // namespace sidestep::limit

namespace sidestep {

template <>
struct EnumNames<limit::StepFreedom> {
  static constexpr std::array<std::pair<limit::StepFreedom, std::string_view>, 3> kNames{
      {{limit::StepFreedom::kNone, "none"},
       {limit::StepFreedom::kPlaces, "places"},
       {limit::StepFreedom::kFree, "free"}}};
};

}  // namespace sidestep
