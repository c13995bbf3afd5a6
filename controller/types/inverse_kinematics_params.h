// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// inverse_kinematics_params: gains of the whole-body inverse kinematics and of what corrects it.
// The CoM needs no gain there: its velocity already answers what the robot is believed to do.

#include "controller/types/field.h"

namespace sidestep {

/// The stack of tasks over base twist and joint velocities, and the CoM-ZMP correction before it.
/// Gains make velocities of position errors; defaults as the paper's iCub experiment.
/// Source: Romualdi et al. (ICRA 2022), section III-C; CoM-ZMP correction: Choi et al., "Posture/
/// walking control for humanoid robot based on kinematic resolution of CoM Jacobian with embedded
/// motion", IEEE Trans. Robotics 23 (2007).
/// The anchors only move the commanded robot as a whole; its joints, and so the servos, do not
/// notice. They act while a foot that is held is felt, each by its rate times the control period of
/// what is left to go.
struct InverseKinematicsParams {
  double foot_linear_gain_per_s{5.0};               ///< Position error of the commanded foot.
  double foot_angular_gain_per_s{4.0};              ///< Against the contact's R_WF.
  double foot_moment_compliance_radps_per_Nm{0.0};  ///< About x and y; 0: stiff.
  double foot_load_compliance_mps_per_N{0.0};       ///< Along z; 0: stiff.
  double swing_attitude_weight{0.0};                ///< 0: exact, as in the paper.
  double torso_gain_per_s{5.0};                     ///< Upright, facing as the feet do.
  double torso_weight{1.0};                         ///< Feet and CoM are exact; this is not.
  double posture_gain_per_s{5.0};                   ///< Of the commanded joints.
  double posture_weight{1e-2};         ///< Small: it settles what the tasks leave open.
  double com_feedback_per_s{4.0};      ///< All three axes.
  double zmp_feedback_per_s{0.3};      ///< Horizontal; needs forces in the feet.
  double position_anchor_per_s{10.0};  ///< Shares above 1 a tick are cut to 1.
  double attitude_anchor_per_s{10.0};  ///< Likewise.
  bool compensates_deflection{true};

  template <typename Self, typename Visitor>
  static void VisitFields(Self& self, Visitor&& visit) {
    const Range gain{0.0, 1e3};
    visit("foot_linear_gain_per_s", self.foot_linear_gain_per_s, gain,
          "velocity of a foot per metre of position error");
    visit("foot_angular_gain_per_s", self.foot_angular_gain_per_s, gain,
          "angular velocity of a foot per radian of error");
    visit("foot_moment_compliance_radps_per_Nm", self.foot_moment_compliance_radps_per_Nm, gain,
          "how fast a standing foot turns with a moment that the plan has not (0: not at all)");
    visit("foot_load_compliance_mps_per_N", self.foot_load_compliance_mps_per_N, gain,
          "how fast a standing foot yields to a load that the plan has not (0: not at all)");
    visit("swing_attitude_weight", self.swing_attitude_weight, gain,
          "weight of a swinging foot's attitude, so that its ankle may stop (0: exact)");
    visit("torso_gain_per_s", self.torso_gain_per_s, gain,
          "angular velocity of the torso per radian of error");
    visit("torso_weight", self.torso_weight, gain, "weight of the torso's orientation task");
    visit("posture_gain_per_s", self.posture_gain_per_s, gain,
          "joint velocity per radian off the home posture");
    visit("posture_weight", self.posture_weight, gain,
          "weight of the posture task, times each joint's own posture_weight");
    visit("com_feedback_per_s", self.com_feedback_per_s, gain,
          "CoM velocity added per metre between planned and estimated CoM");
    visit("zmp_feedback_per_s", self.zmp_feedback_per_s, gain,
          "CoM velocity added per metre between estimated and planned ZMP");
    visit("position_anchor_per_s", self.position_anchor_per_s, gain,
          "rate at which commanded feet are drawn to the estimated ones");
    visit("attitude_anchor_per_s", self.attitude_anchor_per_s, gain,
          "rate at which the commanded base attitude is drawn to the estimated one");
    visit("compensates_deflection", self.compensates_deflection,
          "adds torque over stiffness to the servos' references");
  }
};

}  // namespace sidestep
