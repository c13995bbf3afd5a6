// SPDX-License-Identifier: BSD-3-Clause
#include "models/mjcf/joint_servo.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sidestep {
namespace {

constexpr double kSame = 1e-9;  // of two gains, in the one's size

}  // namespace

bool IsJointServo(const mjModel& model, int actuator) {
  const double gain = model.actuator_gainprm[mjNGAIN * actuator];
  const mjtNum* bias = model.actuator_biasprm + mjNBIAS * actuator;
  const int transmission = model.actuator_trntype[actuator];
  return (transmission == mjTRN_JOINT || transmission == mjTRN_JOINTINPARENT) &&
         model.actuator_gaintype[actuator] == mjGAIN_FIXED &&
         model.actuator_biastype[actuator] == mjBIAS_AFFINE && gain > 0.0 &&
         std::abs(gain + bias[1]) <= kSame * gain && bias[0] == 0.0;
}

double JointEffortLimit_Nm(const mjModel& model, int actuator) {
  const double gear = std::abs(model.actuator_gear[6 * actuator]);
  if (gear == 0.0) return 0.0;
  double limit = std::numeric_limits<double>::infinity();
  const bool is_motor = model.actuator_biastype[actuator] == mjBIAS_NONE;
  if (is_motor && model.actuator_ctrllimited[actuator] != 0) {
    limit = std::abs(model.actuator_gainprm[mjNGAIN * actuator]) *
            RangeBound(model.actuator_ctrlrange + 2 * actuator);
  }
  if (model.actuator_forcelimited[actuator] != 0) {
    limit = std::min(limit, RangeBound(model.actuator_forcerange + 2 * actuator));
  }
  return limit * gear;
}

double RangeBound(const mjtNum* range) {
  const double nearer = std::min(-range[0], range[1]);
  return nearer > 0.0 ? nearer : std::max(std::abs(range[0]), std::abs(range[1]));
}

}  // namespace sidestep
