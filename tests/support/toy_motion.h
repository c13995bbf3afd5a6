// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// toy_motion: what the toy robot does in a synthetic run, told without physics.

#include <Eigen/Core>
#include <string>
#include <vector>

#include "tests/support/synthetic_run.h"

namespace sidestep::testing {

inline constexpr double kToyMass_kg = 20.0;
inline constexpr double kToySwing_s = 0.2;  ///< After the push the right foot swings this long.

/// The toy's story at one instant.
struct Moment {
  Eigen::Vector3d p_WC;
  Eigen::Vector3d v_WC;
  Eigen::Vector3d push_N{Eigen::Vector3d::Zero()};
  double swing{0.0};  ///< 0 before the right foot's step, 1 after it.
  bool is_swinging{false};
  double tilt_rad{0.0};
};

/// A foot at that instant; f_F_W is the ground's force on it (N).
struct FootNow {
  std::string name;
  Eigen::Vector3d p_WF, f_F_W, nominal_p_WF, adjusted_p_WF;
  bool is_down;
};

Moment MomentAt(const SyntheticRun& run, double time_s);

/// Left and right. The left foot never moves.
std::vector<FootNow> FeetAt(const Moment& moment);

/// Configuration of the toy's model: base, then the joints of the left and of the right leg.
Eigen::VectorXd QposAt(const Moment& moment);

}  // namespace sidestep::testing
