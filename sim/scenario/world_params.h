// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// world_params: what a scenario says of the floor and the physics.

#include <vector>

#include "controller/types/field.h"

namespace sidestep {

/// How far the ground reaches from W's origin along x and y, either way (m), where it is not level
/// everywhere: ten times as far as any robot that ships walks in a run that ships.
inline constexpr double kGroundReach_m = 100.0;

/// A rectangle of the ground, its sides along x and y of W, that lies higher or lower than the
/// rest.
struct GroundPatch {
  double from_x_m{0.0};  ///< No defaults: a file must give both.
  double to_x_m{0.0};
  double from_y_m{-kGroundReach_m};
  double to_y_m{kGroundReach_m};
  double height_m{0.0};  ///< Over the ground elsewhere, which is z = 0; negative: a hole.

  template <typename Self, typename Visitor>
  static void VisitFields(Self& self, Visitor&& visit) {
    constexpr Range kReach{-kGroundReach_m, kGroundReach_m};
    visit("from_x_m", self.from_x_m, kReach, Required("where it begins; the robot starts at 0"));
    visit("to_x_m", self.to_x_m, kReach, Required("where it ends"));
    visit("from_y_m", self.from_y_m, kReach, "its right side");
    visit("to_y_m", self.to_y_m, kReach, "its left side");
    visit("height_m", self.height_m, Range{-0.5, 0.5},
          Required("over the rest of the ground; negative: a hole"));
  }
};

/// The world of a run, whatever its plant.
/// What the controller does not know and can't ask: its own friction coefficients and masses are
/// assumptions (MpcParams, InverseDynamicsParams, the robot's nominal model), and a scenario that
/// moves these numbers away from them tests its robustness.
struct WorldParams {
  double friction{0.8};             ///< Coulomb, with every part of the robot.
  double step_s{0.001};             ///< Also the length of a tick, the unit of all times.
  double mass_scale{1.0};           ///< 1: the nominal robot.
  std::vector<GroundPatch> ground;  ///< None overlaps another; empty: level ground.

  template <typename Self, typename Visitor>
  static void VisitFields(Self& self, Visitor&& visit) {
    visit("friction", self.friction, Range{0.0, 10.0},
          "sliding coefficient between foot and floor");
    visit("step_s", self.step_s, Range{1e-5, 0.02}, "one physics step");
    visit("mass_scale", self.mass_scale, Range{0.5, 2.0},
          "every mass and inertia of the plant over what the controller takes it for");
    visit("ground", self.ground, "patches of the ground that are not level with the rest");
  }
};

}  // namespace sidestep
