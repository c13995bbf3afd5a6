// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// world_params: what a scenario says of the floor and the physics.

#include "controller/types/field.h"

namespace sidestep {

/// The world of a run, whatever its plant.
/// What the controller does not know and can't ask: its own friction coefficients and masses are
/// assumptions (MpcParams, InverseDynamicsParams, the robot's nominal model), and a scenario that
/// moves these numbers away from them tests its robustness.
struct WorldParams {
  double friction{0.8};    ///< Coulomb, with every part of the robot.
  double step_s{0.001};    ///< Also the length of a tick, the unit of all times.
  double mass_scale{1.0};  ///< 1: the nominal robot.

  template <typename Self, typename Visitor>
  static void VisitFields(Self& self, Visitor&& visit) {
    visit("friction", self.friction, Range{0.0, 10.0},
          "sliding coefficient between foot and floor");
    visit("step_s", self.step_s, Range{1e-5, 0.02}, "one physics step");
    visit("mass_scale", self.mass_scale, Range{0.5, 2.0},
          "every mass and inertia of the plant over what the controller takes it for");
  }
};

}  // namespace sidestep
