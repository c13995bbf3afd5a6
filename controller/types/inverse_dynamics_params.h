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
  double force_weight{1e-3};    ///< On contact force minus the MPC's, per N^2.
  double posture_weight{1e-4};  ///< On accelerations that no task asks for.
  double friction{0.5};         ///< Coefficient of the cones the forces must keep.

  template <typename Self, typename Visitor>
  static void VisitFields(Self& self, Visitor&& visit) {
    visit("com_stiffness_per_s2", self.com_stiffness_per_s2, Range{0.0, 1e5});
    visit("com_damping_per_s", self.com_damping_per_s, Range{0.0, 1e4});
    visit("attitude_stiffness_per_s2", self.attitude_stiffness_per_s2, Range{0.0, 1e5});
    visit("attitude_damping_per_s", self.attitude_damping_per_s, Range{0.0, 1e4});
    visit("swing_stiffness_per_s2", self.swing_stiffness_per_s2, Range{0.0, 1e5});
    visit("swing_damping_per_s", self.swing_damping_per_s, Range{0.0, 1e4});
    visit("com_weight", self.com_weight, Range{0.0, 1e6});
    visit("attitude_weight", self.attitude_weight, Range{0.0, 1e6});
    visit("swing_weight", self.swing_weight, Range{0.0, 1e6});
    visit("force_weight", self.force_weight, Range{0.0, 1e6});
    visit("posture_weight", self.posture_weight, Range{0.0, 1e6});
    visit("friction", self.friction, Range{0.01, 10.0});
  }
};

}  // namespace sidestep
