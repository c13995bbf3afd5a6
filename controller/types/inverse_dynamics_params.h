// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// inverse_dynamics_params: gains and weights of the whole-body inverse dynamics.

#include "controller/types/field.h"

namespace sidestep {

/// Gains and weights of the inverse dynamics. Accelerations are tracked in SI units.
/// Each tracked acceleration is a* = a_ref + stiffness (p_ref - p) + damping (v_ref - v); damping =
/// 2 sqrt(stiffness) is critical, which CoM and swinging feet have by default. Only ratios of
/// weights matter: accelerations weigh about 1, and force_weight and posture_weight are small
/// enough to decide what the tasks leave open and no more. Standing feet have a weight of their own
/// in inverse_dynamics.cc, above the defaults of all these.
struct InverseDynamicsParams {
  double com_stiffness_per_s2{100.0};       ///< About 10 rad/s, undamped.
  double com_damping_per_s{20.0};           ///< Critical.
  double attitude_stiffness_per_s2{200.0};  ///< Roll and pitch; yaw has none.
  double attitude_damping_per_s{30.0};      ///< All three axes.
  double swing_stiffness_per_s2{900.0};     ///< About 30 rad/s, undamped.
  double swing_damping_per_s{60.0};         ///< Critical.
  double com_weight{1.0};                   ///< Not in flight, where forces are none.
  double attitude_weight{0.1};              ///< About yaw only on two feet: a point has no grip.
  double swing_weight{1.0};                 ///< Per (m/s^2)^2, as the CoM's.
  double force_weight{1e-3};                ///< Draws to FootTarget::vertex_force_N.
  double posture_weight{1e-4};              ///< On every entry of nudot, the base's included.
  double friction{0.5};  ///< Of the pyramid; above MpcParams::friction by default.

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
