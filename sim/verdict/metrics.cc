// SPDX-License-Identifier: BSD-3-Clause
#include "sim/verdict/metrics.h"

#include <algorithm>
#include <array>

namespace sidestep {
namespace {

constexpr MetricGroup kTruth = MetricGroup::kTruth;
constexpr MetricGroup kController = MetricGroup::kController;

constexpr std::array kMetrics{
    MetricInfo{
        "fall", "",
        "base too low or too tilted for `verdict`, or a body other than a foot on the ground", true,
        kTruth},
    MetricInfo{
        "slip", "",
        "a foot slid under load by more than verdict.max_slip_m in one stance, before any fall",
        true, kTruth},
    MetricInfo{"fall_time_s", "s", "when the fall was first seen", false, kTruth},
    MetricInfo{"min_base_height_m", "m",
               "lowest height of the base; of the CoM on the centroidal plant", false, kTruth},
    MetricInfo{"max_base_height_m", "m",
               "greatest height of the base; of the CoM on the centroidal plant", false, kTruth},
    MetricInfo{
        "min_base_height_ratio", "",
        "min_base_height_m over the robot's base_height_m; com_height_m on the centroidal plant",
        false, kTruth},
    MetricInfo{"max_base_height_ratio", "", "max_base_height_m likewise", false, kTruth},
    MetricInfo{"max_tilt_rad", "rad",
               "largest angle of the base from its attitude at the start, yaw apart", false,
               kTruth},
    MetricInfo{"max_angular_momentum_kgm2ps", "kg m^2/s",
               "largest angular momentum about the CoM; a reduced model can spin but not tilt",
               false, kTruth},
    MetricInfo{"max_slip_m", "m", "farthest slide of a loaded foot in one stance, planned or not",
               false, kTruth},
    MetricInfo{"final_path_error_m", "m",
               "horizontal distance from the CoM to its nominal path line at the end", false,
               kTruth},
    MetricInfo{"max_path_error_m", "m",
               "largest horizontal distance from the CoM to its nominal path line", false, kTruth},
    MetricInfo{
        "final_speed_error_mps", "m/s",
        "mean horizontal CoM velocity of the last gait cycle against the nominal one, at the end",
        false, kTruth},
    MetricInfo{
        "drift_m", "m",
        "mean offset of the CoM from its nominal path line over the last gait cycle, at the end",
        false, kTruth},
    MetricInfo{
        "recovered", "",
        "no fall, and from every push the robot recovered (path, speed and tilt for 1 s; README)",
        true, kTruth},
    MetricInfo{"recovery_time_s", "s",
               "longest time from a push's end until the robot recovered; infinite if it did not",
               false, kTruth},
    MetricInfo{"mean_step_adjustment_m", "m",
               "mean horizontal distance of the steps taken from the nominal steps, from the first "
               "push on",
               false, kTruth},
    MetricInfo{
        "max_step_adjustment_m", "m",
        "largest horizontal distance of a step taken from the nominal step, from the first push on",
        false, kTruth},
    MetricInfo{"mean_forward_speed_mps", "m/s", "CoM advance along x over the duration", false,
               kTruth},
    MetricInfo{
        "gait_speed_mps", "m/s",
        "horizontal speed of the CoM over the whole strides of the last gait that is no stand",
        false, kTruth},
    MetricInfo{"step_length_m", "m",
               "advance of the feet from one touch-down to the next, over the same strides", false,
               kTruth},
    MetricInfo{"step_frequency_hz", "Hz", "steps of all feet a second, likewise", false, kTruth},
    MetricInfo{
        "duty_factor", "",
        "share of the time in which a foot is in stance (it bears 5 % of the weight, or did so and "
        "will within 10 ms), mean of the feet, likewise",
        false, kTruth},
    MetricInfo{"walk_flight_fraction", "",
               "share of the time of all walks in which no foot is in stance, once one has been",
               false, kTruth},
    MetricInfo{
        "run_flight_fraction", "",
        "share of the time in which no foot is in stance, over the whole strides of all runs "
        "and hops",
        false, kTruth},
    MetricInfo{"cost_of_transport", "",
               "positive mechanical work of the joints over weight times way of the CoM, over the "
               "strides of gait_speed_mps",
               false, kTruth},
    MetricInfo{"max_ground_force_ratio", "",
               "largest vertical force of the ground on one foot over the weight, likewise", false,
               kTruth},
    MetricInfo{"apex_height_error_m", "m",
               "largest difference of the CoM's apex in a flight from the nominal CoM's", false,
               kTruth},
    MetricInfo{
        "min_swing_clearance_m", "m",
        "lowest apex of a swing's lowest corner above the ground, over all swings that ended",
        false, kTruth},
    MetricInfo{"max_sole_tilt_rad", "rad",
               "largest angle from level of the sole of a foot that stands under load", false,
               kTruth},
    MetricInfo{"max_self_penetration_m", "m", "deepest that two bodies of the robot met", false,
               kTruth},
    MetricInfo{"min_joint_margin_rad", "rad",
               "least distance of a joint from its limits; negative beyond them", false, kTruth},
    MetricInfo{"max_torque_ratio", "", "largest torque of a motor over its limit", false, kTruth},
    MetricInfo{"max_joint_speed_ratio", "",
               "largest speed of a joint over its limit, where the robot tells one", false, kTruth},
    MetricInfo{"torque_saturation_s", "s", "time in which some motor was asked for too much", false,
               kTruth},
    MetricInfo{"energy_J", "J", "integral of the absolute power of the actuators", false, kTruth},
    MetricInfo{"planned_mean_step_adjustment_m", "m",
               "mean horizontal distance of the planned footholds from the planner's nominal ones, "
               "likewise",
               false, kController},
    MetricInfo{"planned_max_step_adjustment_m", "m",
               "largest horizontal distance of a planned foothold from the planner's nominal, from "
               "the first push on",
               false, kController},
    MetricInfo{"mpc_failures", "", "MPC solves that did not converge", false, kController},
    MetricInfo{"wbc_failures", "",
               "whole-body problems that were not solved, or only after exact tasks gave way",
               false, kController},
    MetricInfo{"step_failures", "", "step problems of stepping: dcm_qp that were not solved", false,
               kController},
    MetricInfo{
        "max_solver_failure_ratio", "",
        "largest share of a solver's problems (MPC, whole body, step) that it did not solve, "
        "before any fall",
        false, kController},
    MetricInfo{"solver_fallbacks", "", "times a shifted older plan stood in for a failed solve",
               false, kController},
    MetricInfo{"max_cone_violation_N", "N",
               "farthest that a planned ground force left the controller's friction cone", false,
               kController},
    MetricInfo{"max_box_violation_m", "m",
               "farthest that a planned foothold left its box before the foot landed", false,
               kController},
    MetricInfo{"rms_com_velocity_error_mps", "m/s",
               "root mean square error of the CoM velocity that the controller believes", false,
               kController},
    MetricInfo{"max_com_velocity_error_mps", "m/s",
               "largest error of the CoM velocity that the controller believes", false,
               kController},
    MetricInfo{"rms_pushed_com_velocity_error_mps", "m/s",
               "rms_com_velocity_error_mps from each push's start to 1 s after its end", false,
               kController},
    MetricInfo{"max_pushed_com_velocity_error_mps", "m/s", "max_com_velocity_error_mps likewise",
               false, kController},
    MetricInfo{"rms_push_estimate_error_N", "N",
               "root mean square error of the horizontal push that the controller believes, "
               "nothing included",
               false, kController},
    MetricInfo{"max_push_estimate_error_N", "N",
               "largest error of the horizontal push that the controller believes", false,
               kController},
};

}  // namespace

std::span<const MetricInfo> KnownMetrics() { return kMetrics; }

const MetricInfo* FindMetric(std::string_view name) {
  const auto found = std::find_if(kMetrics.begin(), kMetrics.end(),
                                  [&](const MetricInfo& metric) { return metric.name == name; });
  return found == kMetrics.end() ? nullptr : &*found;
}

}  // namespace sidestep
