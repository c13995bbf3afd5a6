// SPDX-License-Identifier: BSD-3-Clause
#include "sim/verdict/metrics.h"

#include <algorithm>
#include <array>

namespace sidestep {
namespace {

constexpr std::array kMetrics{
    MetricInfo{"fall", "", "the base sank or tilted beyond the bounds of `verdict`", true},
    MetricInfo{"slip", "", "a standing foot slid farther than verdict.max_slip_m", true},
    MetricInfo{"fall_time_s", "s", "when the fall was first seen", false},
    MetricInfo{"min_base_height_m", "m", "lowest height of the base", false},
    MetricInfo{"max_base_height_m", "m", "greatest height of the base", false},
    MetricInfo{"max_tilt_rad", "rad", "largest angle of the base from its upright", false},
    MetricInfo{"max_angular_momentum_kgm2ps", "kg m^2/s",
               "largest angular momentum about the CoM; a reduced model can spin but not tilt",
               false},
    MetricInfo{"max_slip_m", "m", "farthest slide of a foot in one planned stance", false},
    MetricInfo{"final_path_error_m", "m",
               "horizontal distance from CoM to its nominal path at the end", false},
    MetricInfo{"final_speed_error_mps", "m/s",
               "horizontal CoM velocity against its nominal at the end", false},
    MetricInfo{
        "recovery_time_s", "s",
        "from the last push's end until path error < 0.05 m and speed error < 0.1 m/s for good",
        false},
    MetricInfo{"max_path_error_m", "m", "largest horizontal distance from CoM to its nominal path",
               false},
    MetricInfo{"mean_step_adjustment_m", "m",
               "mean horizontal distance from nominal to adjusted footholds", false},
    MetricInfo{"max_step_adjustment_m", "m",
               "largest horizontal distance from a nominal to its adjusted foothold", false},
    MetricInfo{"mean_forward_speed_mps", "m/s", "CoM advance along x over the duration", false},
    MetricInfo{"apex_height_error_m", "m", "largest error of a flight's apex against the nominal",
               false},
    MetricInfo{"mpc_failures", "", "MPC solves that did not converge", false},
    MetricInfo{"wbc_failures", "", "whole-body problems that were not solved", false},
    MetricInfo{"solver_fallbacks", "", "times a shifted older plan stood in for a failed solve",
               false},
    MetricInfo{"max_cone_violation_N", "N",
               "farthest that a ground force left the controller's friction cone", false},
    MetricInfo{"max_box_violation_m", "m", "farthest that an adjusted foothold left its box",
               false},
    MetricInfo{"min_swing_clearance_m", "m",
               "lowest apex of a swing's lowest corner above the ground, over all swings", false},
    MetricInfo{"max_sole_tilt_rad", "rad",
               "largest angle of a standing, loaded foot's sole from level", false},
    MetricInfo{"max_self_penetration_m", "m", "deepest that two bodies of the robot met", false},
    MetricInfo{"min_joint_margin_rad", "rad",
               "least distance of a joint from its limits; negative beyond them", false},
    MetricInfo{"max_torque_ratio", "", "largest torque of a motor over its limit", false},
    MetricInfo{"torque_saturation_s", "s", "time in which some motor was asked for too much",
               false},
    MetricInfo{"energy_J", "J", "integral of the absolute power of the actuators", false},
};

}  // namespace

std::span<const MetricInfo> KnownMetrics() { return kMetrics; }

const MetricInfo* FindMetric(std::string_view name) {
  const auto found = std::find_if(kMetrics.begin(), kMetrics.end(),
                                  [&](const MetricInfo& metric) { return metric.name == name; });
  return found == kMetrics.end() ? nullptr : &*found;
}

}  // namespace sidestep
