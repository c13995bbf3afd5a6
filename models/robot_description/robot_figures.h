// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// robot_figures: a robot in a few numbers, as it starts: mass, height of the CoM, legs, soles, and
// how far its servos are from being too weak or too hard.
//
// A servo is too weak if it can't hold the robot up: standing on one foot it is an inverted
// pendulum about that servo, which falls unless stiffness > m g h. It is too hard if it is unstable
// in physics steps of dt. MuJoCo integrates a servo's torque, held over the step, as
//
//   v' = v - dt (k q + d v) / I,   q' = q + dt v'
//
// with I the inertia that the joint moves. With a = d dt / I and b = k dt^2 / I that is stable if
// a > 0 and 2 a + b < 4 (Jury's test of its characteristic polynomial), and turns the velocity
// round within a step from a = 1 on. I is no less than the armature: where armature > damping x
// step all is well.

#include <Eigen/Core>
#include <string>
#include <vector>

#include "models/robot_description/robot_description.h"

namespace sidestep {

/// Of m g h, that a servo needs in practice. Measured: the generic humanoid walks on legs of 4 m g
/// h and falls on 2.5.
inline constexpr double kStiffEnough = 3.0;

struct ServoFigures {
  std::string joint;
  double stiffness_Nm_per_rad{0.0};
  double damping_Nms_per_rad{0.0};
  double armature_kgm2{0.0};
  /// What the joint moves, armature included, while the robot floats: 1 / (M^-1)_jj.
  double inertia_kgm2{0.0};
  double carries_Nm_per_rad{
      0.0};  ///< m g h, of a joint of the legs that keeps them upright; else 0.

  double damping_share(double step_s) const { return damping_Nms_per_rad * step_s / inertia_kgm2; }
  double stiffness_share(double step_s) const {
    return stiffness_Nm_per_rad * step_s * step_s / inertia_kgm2;
  }
  bool is_stable(double step_s) const {
    return damping_share(step_s) < 1.0 &&
           2.0 * damping_share(step_s) + stiffness_share(step_s) < 4.0;
  }
  bool is_weak() const { return stiffness_Nm_per_rad < kStiffEnough * carries_Nm_per_rad; }
};

struct SoleFigures {
  std::string foot;
  double length_m{0.0};  ///< Of the rectangle around the vertices, along x and y of F.
  double width_m{0.0};
  Eigen::Vector3d p_WF{Eigen::Vector3d::Zero()};  ///< m, at the start.
  double leg_length_m{0.0};                       ///< 0 where there is no leg; see StretchedLeg.
};

struct RobotFigures {
  double mass_kg{0.0};
  double com_height_m{0.0};  ///< Of the start, above the floor.
  double omega_per_s{0.0};   ///< sqrt(g / h) of RobotDescription::com_height_m.
  std::vector<SoleFigures> soles;
  std::vector<ServoFigures> servos;  ///< In the order of RobotDescription::joints.
};

/// Figures of a robot with a model. Throws ConfigError for names that the model lacks.
RobotFigures FiguresOf(const RobotDescription& robot);

/// What is worth a warning before a robot is moved by its servos, a line each, without a place:
/// servos too weak to carry it, joints without armature.
std::vector<std::string> ServoWarnings(const RobotDescription& robot);

}  // namespace sidestep
