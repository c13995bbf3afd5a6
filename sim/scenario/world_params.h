// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// world_params: what a scenario says of the floor and the physics.

#include "controller/types/field.h"

namespace sidestep {

/// The world of a run, whatever its plant.
struct WorldParams {
  double friction{0.8};
  double step_s{0.001};
  double mass_scale{1.0};

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
