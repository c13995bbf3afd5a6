// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// choose_gait: a walk for a robot's size, and the controller's settings that depend on it.
//
// A walk looks the same at every size if lengths are shares of the CoM's height h and times of
// 1 / omega = sqrt(h / g). The shares are generic_humanoid's.

#include "models/import/start_pose.h"

namespace sidestep::importer {

/// Of the scenarios that are written.
struct Gait {
  bool stands{true};  ///< Else it must step from the start on.
  double omega_radps{0.0};
  double step_length_m{0.0};
  double step_width_m{0.0};
  double swing_s{0.0};  ///< Whole steps of the MPC, as the next.
  double double_support_s{0.0};
  double swing_height_m{0.0};
  double landing_speed_mps{0.0};
};

/// @param on_points  Whether the feet are points, on which a robot can't stand still.
Gait ChooseGait(const StartPose& start, bool on_points);

/// Gives the swing `least_s` at least, in whole steps of the MPC. Returns whether it was shorter.
bool SlowDown(double least_s, Gait* gait);

/// Of robot.yaml's `control`. Momentum and force are divided by the mass in the MPC, so that its
/// weights depend on the height alone.
struct ControlFigures {
  double com_weight{0.0};       ///< Horizontal, per m^2.
  double height_weight{0.0};    ///< Vertical, likewise.
  double momentum_weight{0.0};  ///< Per (m^2/s)^2.
  double contact_threshold_N{0.0};
  double push_deadband_N{0.0};
  double foot_moment_compliance_radps_per_Nm{0.0};
  double foot_load_compliance_mps_per_N{0.0};
};

ControlFigures ChooseControl(double mass_kg, double com_height_m);

/// The same of a robot on points, by the figures of Bolt (1.25 kg, CoM 0.35 m high).
ControlFigures ChoosePointControl(double mass_kg, double com_height_m);

}  // namespace sidestep::importer
