// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// inverse_dynamics_params: gains and weights of the whole-body inverse dynamics.

#include "controller/types/field.h"

namespace sidestep {

/// Gains and weights of the inverse dynamics. Accelerations are tracked in SI units.
struct InverseDynamicsParams {
  double com_stiffness_per_s2{100.0};
  double com_damping_per_s{20.0};
  double attitude_stiffness_per_s2{200.0};
  double attitude_damping_per_s{30.0};
  double swing_stiffness_per_s2{900.0};
  double swing_damping_per_s{60.0};
  double com_weight{1.0};
  double attitude_weight{0.1};
  double swing_weight{1.0};
  double force_weight{1e-3};
  double posture_weight{1e-4};
  double friction{0.5};

  template <typename Self, typename Visitor>
  static void VisitFields(Self& self, Visitor&& visit) {
    visit("com_stiffness_per_s2", self.com_stiffness_per_s2, Range{0.0, 1e5},
          "CoM acceleration per metre of position error");
    visit("com_damping_per_s", self.com_damping_per_s, Range{0.0, 1e4},
          "CoM acceleration per m/s of velocity error");
    visit("attitude_stiffness_per_s2", self.attitude_stiffness_per_s2, Range{0.0, 1e5},
          "angular acceleration of the base per radian of error");
    visit("attitude_damping_per_s", self.attitude_damping_per_s, Range{0.0, 1e4},
          "angular acceleration of the base per rad/s of error");
    visit("swing_stiffness_per_s2", self.swing_stiffness_per_s2, Range{0.0, 1e5},
          "acceleration of a swinging foot per metre of error");
    visit("swing_damping_per_s", self.swing_damping_per_s, Range{0.0, 1e4},
          "acceleration of a swinging foot per m/s of error");
    visit("com_weight", self.com_weight, Range{0.0, 1e6}, "weight of the CoM task");
    visit("attitude_weight", self.attitude_weight, Range{0.0, 1e6},
          "weight of the base's orientation task");
    visit("swing_weight", self.swing_weight, Range{0.0, 1e6}, "weight of the swinging feet");
    visit("force_weight", self.force_weight, Range{0.0, 1e6},
          "weight of the contact forces' distance from the MPC's, per N^2");
    visit("posture_weight", self.posture_weight, Range{0.0, 1e6},
          "weight on accelerations that no task asks for");
    visit("friction", self.friction, Range{0.01, 10.0},
          "coefficient of the friction cones that the contact forces must keep");
  }
};

}  // namespace sidestep
