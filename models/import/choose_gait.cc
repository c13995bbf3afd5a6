// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/choose_gait.h"

#include <algorithm>
#include <cmath>

#include "models/import/text.h"
#include "models/support/gravity.h"

namespace sidestep::importer {
namespace {

constexpr double kKnot_s = 0.05;  // of the MPC in robot.yaml; the gait's times are whole ones

// Over 1 / omega, over the leg's length and over the CoM's height.
constexpr double kSwing = 1.4;
constexpr double kDoubleSupport = 0.35;
constexpr double kStepLength = 0.12;
constexpr double kSwingHeight = 0.037;
constexpr double kLandingSpeed = 0.0071;  // over sqrt(g h)

// Of feet that are points: a low, soft landing would be a late one, and the fall is over it by
// then.
constexpr double kPointSwingHeight = 0.11;
constexpr double kPointLandingSpeed = 0.053;

// generic_humanoid's, which the weights and thresholds were found with.
constexpr double kHeight_m = 0.8149;
constexpr double kWeight_N = 60.0 * kGravity_mps2;

// Bolt's, with whose the weights on points were found.
constexpr double kPointHeight_m = 0.35;

double Knots(double time_s, double least_s) {
  return std::max(least_s, kKnot_s * std::round(time_s / kKnot_s));
}

}  // namespace

Gait ChooseGait(const StartPose& start, bool on_points) {
  const double h = start.com_height_m;
  Gait gait;
  gait.stands = !on_points;
  gait.omega_radps = std::sqrt(kGravity_mps2 / h);
  gait.step_length_m = Rounded(kStepLength * start.leg_length_m, 2);
  gait.step_width_m = Rounded(start.step_width_m, 3);
  gait.swing_s = Knots(kSwing / gait.omega_radps, 4 * kKnot_s);
  gait.double_support_s = Knots(kDoubleSupport / gait.omega_radps, kKnot_s);
  gait.swing_height_m = Rounded((on_points ? kPointSwingHeight : kSwingHeight) * h, 2);
  gait.landing_speed_mps =
      Rounded((on_points ? kPointLandingSpeed : kLandingSpeed) * std::sqrt(kGravity_mps2 * h), 2);
  return gait;
}

bool SlowDown(double least_s, Gait* gait) {
  const bool is_slower = least_s > gait->swing_s;
  if (is_slower) gait->swing_s = kKnot_s * std::ceil(least_s / kKnot_s);
  return is_slower;
}

ControlFigures ChooseControl(double mass_kg, double com_height_m) {
  const double size = com_height_m / kHeight_m;
  const double weight = mass_kg * kGravity_mps2 / kWeight_N;
  ControlFigures figures;
  figures.com_weight = Rounded(2000.0 / (size * size));
  figures.height_weight = Rounded(100000.0 / (size * size));
  figures.momentum_weight = Rounded(5000.0 / (size * size * size));
  figures.contact_threshold_N = Rounded(25.0 * weight);
  figures.push_deadband_N = Rounded(20.0 * weight);
  figures.foot_moment_compliance_radps_per_Nm = Rounded(0.002 / (weight * size));
  // Over the stiffness of a leg on its servos, m g / h: the loop's bandwidth, which the
  // controller's period bounds whatever the robot's size.
  figures.foot_load_compliance_mps_per_N = Rounded(0.0001 * size / weight);
  return figures;
}

ControlFigures ChoosePointControl(double mass_kg, double com_height_m) {
  const double size = com_height_m / kPointHeight_m;
  ControlFigures figures = ChooseControl(mass_kg, com_height_m);
  figures.com_weight = Rounded(100.0 / (size * size));
  figures.height_weight = Rounded(2000.0 / (size * size));
  figures.momentum_weight = Rounded(1000.0 / (size * size * size));
  return figures;
}

}  // namespace sidestep::importer
