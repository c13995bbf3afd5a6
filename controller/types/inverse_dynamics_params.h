// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// inverse_dynamics_params: gains and weights of the whole-body inverse dynamics.

#include "controller/types/field.h"

namespace sidestep {

/// Gains and weights of the inverse dynamics. Accelerations are tracked in SI units.
/// Each tracked acceleration is a* = a_ref + stiffness (p_ref - p) + damping (v_ref - v); damping =
/// 2 sqrt(stiffness) is critical. Only ratios of weights matter, and none depends on the robot's
/// size: forces are weighed by the share of the robot's weight that they are, and the moment about
/// the CoM by the acceleration that the same force would give it from the CoM's height. Defaults
/// are the iCub's: a humanoid on flat feet whose MPC owns the angular momentum. The trunk is soft
/// then, for a stiff one takes back the turn that a push gives the body, at the cost of the centre
/// of pressure (70 N m are 0.14 m of it). A robot whose trunk is to be held instead sets
/// angular_momentum_weight to 0 and attitude_* up.
struct InverseDynamicsParams {
  double com_stiffness_per_s2{30.0};      ///< Horizontal; about 5 rad/s, undamped.
  double com_damping_per_s{10.0};         ///< Horizontal.
  double height_stiffness_per_s2{100.0};  ///< The CoM's, vertical; 10 rad/s, undamped.
  double height_damping_per_s{20.0};      ///< Critical.
  double com_weight{10.0};                ///< Not in flight, where forces are none.
  double angular_momentum_gain_per_s{5.0};
  double angular_momentum_weight{16.0};  ///< Per (m/s^2)^2 of moment / (mass * CoM height).
  double attitude_stiffness_per_s2{40.0};
  double attitude_damping_per_s{10.0};
  double attitude_weight{0.3};           ///< About yaw not on a single point, which has no grip.
  double swing_stiffness_per_s2{900.0};  ///< About 30 rad/s, undamped.
  double swing_damping_per_s{60.0};      ///< Critical.
  double swing_weight{20.0};             ///< Per (m/s^2)^2, as the CoM's.
  double swing_rotation_stiffness_per_s2{400.0};  ///< Of a foot with an area.
  double swing_rotation_damping_per_s{40.0};      ///< Critical.
  double swing_rotation_weight{2.0};
  double stand_weight{1000.0};  ///< Above all: the ground holds that foot.
  double stand_rotation_weight{100.0};
  double posture_stiffness_per_s2{50.0};
  double posture_damping_per_s{14.0};  ///< Critical.
  double posture_weight{0.05};         ///< Of joints that carry no foot.
  double leg_posture_weight{0.005};    ///< Of those that do: enough to decide what is left open.
  double planned_force_weight{0.26};   ///< Draws to FootTarget::vertex_force_N.
  double friction{0.6};                ///< Of the pyramid; above MpcParams::friction by default.

  template <typename Self, typename Visitor>
  static void VisitFields(Self& self, Visitor&& visit) {
    const Range stiffness{0.0, 1e5}, damping{0.0, 1e4}, weight{0.0, 1e6};
    visit("com_stiffness_per_s2", self.com_stiffness_per_s2, stiffness,
          "horizontal CoM acceleration per metre of position error");
    visit("com_damping_per_s", self.com_damping_per_s, damping,
          "horizontal CoM acceleration per m/s of velocity error");
    visit("height_stiffness_per_s2", self.height_stiffness_per_s2, stiffness,
          "vertical CoM acceleration per metre of position error");
    visit("height_damping_per_s", self.height_damping_per_s, damping,
          "vertical CoM acceleration per m/s of velocity error");
    visit("com_weight", self.com_weight, weight, "weight of the CoM task");
    visit("angular_momentum_gain_per_s", self.angular_momentum_gain_per_s, damping,
          "moment about the CoM per error of the angular momentum against the plan's");
    visit(
        "angular_momentum_weight", self.angular_momentum_weight, weight,
        "weight of that moment over mass and height, as an acceleration (0: the trunk's task owns "
        "the angular momentum)");
    visit("attitude_stiffness_per_s2", self.attitude_stiffness_per_s2, stiffness,
          "angular acceleration of the trunk per radian of error");
    visit("attitude_damping_per_s", self.attitude_damping_per_s, damping,
          "angular acceleration of the trunk per rad/s of error");
    visit("attitude_weight", self.attitude_weight, weight, "weight of the trunk's attitude");
    visit("swing_stiffness_per_s2", self.swing_stiffness_per_s2, stiffness,
          "acceleration of a swinging foot per metre of error");
    visit("swing_damping_per_s", self.swing_damping_per_s, damping,
          "acceleration of a swinging foot per m/s of error");
    visit("swing_weight", self.swing_weight, weight, "weight of the swinging feet's place");
    visit("swing_rotation_stiffness_per_s2", self.swing_rotation_stiffness_per_s2, stiffness,
          "angular acceleration of a swinging sole per radian of error");
    visit("swing_rotation_damping_per_s", self.swing_rotation_damping_per_s, damping,
          "angular acceleration of a swinging sole per rad/s of error");
    visit("swing_rotation_weight", self.swing_rotation_weight, weight,
          "weight of the swinging soles' attitude");
    visit("stand_weight", self.stand_weight, weight, "weight of a standing foot's staying there");
    visit("stand_rotation_weight", self.stand_rotation_weight, weight,
          "weight of a standing sole's staying flat");
    visit("posture_stiffness_per_s2", self.posture_stiffness_per_s2, stiffness,
          "acceleration of a joint per radian from its place at the start");
    visit("posture_damping_per_s", self.posture_damping_per_s, damping,
          "acceleration of a joint per rad/s of its speed");
    visit("posture_weight", self.posture_weight, weight,
          "weight of the posture of joints that carry no foot, times the joint's own");
    visit("leg_posture_weight", self.leg_posture_weight, weight,
          "weight of the posture of joints that carry a foot, times the joint's own");
    visit("planned_force_weight", self.planned_force_weight, weight,
          "weight of the contact forces' distance from the MPC's, as shares of the robot's weight");
    visit("friction", self.friction, Range{0.01, 10.0},
          "coefficient of the friction cones that the contact forces must keep");
  }
};

}  // namespace sidestep
