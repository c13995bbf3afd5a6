// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// control_params: every setting of the controller, as a scenario's `control:` block spells it.

#include <Eigen/Core>
#include <array>
#include <string_view>
#include <utility>

#include "controller/types/dcm_params.h"
#include "controller/types/field.h"
#include "controller/types/gait_params.h"
#include "controller/types/inverse_dynamics_params.h"
#include "controller/types/inverse_kinematics_params.h"
#include "controller/types/mpc_params.h"

namespace sidestep {

enum class ControlMode {
  kTorque,    ///< Whole-body inverse dynamics.
  kPosition,  ///< Whole-body inverse kinematics, integrated to references of the joints' servos.
  kPassive,   ///< Does nothing: zero torque. The negative control of every scenario.
};

template <>
struct EnumNames<ControlMode> {
  static constexpr std::array<std::pair<ControlMode, std::string_view>, 3> kNames{
      {{ControlMode::kTorque, "torque"},
       {ControlMode::kPosition, "position"},
       {ControlMode::kPassive, "passive"}}};
};

/// What the controller knows of a push.
enum class ExternalWrenchKnowledge {
  kUnknown,    ///< Nothing but what it does to the state.
  kEstimated,  ///< What it feels: by the arms' force/torque sensors and by its momentum.
  kKnown       ///< All, from the simulation.
};

template <>
struct EnumNames<ExternalWrenchKnowledge> {
  static constexpr std::array<std::pair<ExternalWrenchKnowledge, std::string_view>, 3> kNames{
      {{ExternalWrenchKnowledge::kUnknown, "unknown"},
       {ExternalWrenchKnowledge::kEstimated, "estimated"},
       {ExternalWrenchKnowledge::kKnown, "known"}}};
};

/// Where the belief comes from. kTruth is for comparisons: it needs SensorFrame::truth, which no
/// robot has. The centroidal plant has an estimator of its own and heeds neither.
enum class EstimatorKind { kSensors, kTruth };

template <>
struct EnumNames<EstimatorKind> {
  static constexpr std::array<std::pair<EstimatorKind, std::string_view>, 2> kNames{
      {{EstimatorKind::kSensors, "sensors"}, {EstimatorKind::kTruth, "truth"}}};
};

/// What decides the CoM's motion, the feet's forces and footholds, and when feet land. The others
/// are baselines to compare the MPC with: two feet, mode torque, walk and stand.
enum class Stepping {
  kMpc,          ///< The model predictive control.
  kDcmQp,        ///< Step place and time by a QP on the DCM (dcm/step_qp.h), and DCM tracking.
  kCapturePoint  ///< Steps to the capture point by the clock (dcm/step_qp.h), and DCM tracking.
};

template <>
struct EnumNames<Stepping> {
  static constexpr std::array<std::pair<Stepping, std::string_view>, 3> kNames{
      {{Stepping::kMpc, "mpc"},
       {Stepping::kDcmQp, "dcm_qp"},
       {Stepping::kCapturePoint, "capture_point"}}};
};

/// Noise that the state estimator assumes (standard deviations) and its contact threshold.
/// The *_noise_* fields are what LegOdometry believes of its inputs, not what the simulation adds:
/// that is SensorParams. A deviation that is too small makes the filter trust that input too much.
/// Of the rest, wrench_* are for the arms' force/torque sensors and push_* for the momentum
/// observer; both count only under ExternalWrenchKnowledge::kEstimated, and both are one low-pass
/// of first order and one deadband, on the norm of the smoothed force.
struct EstimatorParams {
  double accelerometer_noise_mps2{0.2};  ///< Per axis and frame; drives the prediction.
  double foot_position_noise_m{0.001};   ///< Per axis and frame.
  double foot_velocity_noise_mps{0.05};  ///< Per axis and frame.
  double foot_slip_noise_mps{0.01};      ///< A foothold may wander by this times dt a frame.
  double foot_turn_doubt_radps{0.2};     ///< Of soles; the resting point of a point foot is known.
  double floor_noise_m{0.0};             ///< 0: level to 2 mm, in every frame of a stance anew.
  double contact_threshold_N{0.3};       ///< Decides FootState::in_contact.
  double wrench_cutoff_hz{10.0};         ///< Forces and torques alike.
  double wrench_deadband_N{15.0};        ///< Below it the torque is dropped as well.
  double push_cutoff_hz{0.0};            ///< 0 switches the momentum observer off.
  double push_deadband_N{20.0};          ///< Of the horizontal force, the only one observed.
  double push_settle_s{0.02};            ///< After a foot has landed, its shock would be a push.
  double push_decay_s{0.15};             ///< Of a push meanwhile; 1/e is left after it.
  double push_limit_ratio{1.0};          ///< Of what is felt in one frame.

  template <typename Self, typename Visitor>
  static void VisitFields(Self& self, Visitor&& visit) {
    visit("accelerometer_noise_mps2", self.accelerometer_noise_mps2, Range{1e-6, 100.0},
          "assumed standard deviation of the accelerometer's noise");
    visit("foot_position_noise_m", self.foot_position_noise_m, Range{1e-6, 1.0},
          "assumed standard deviation of a standing foot's position by kinematics");
    visit("foot_velocity_noise_mps", self.foot_velocity_noise_mps, Range{1e-6, 10.0},
          "assumed standard deviation of a standing foot's velocity by kinematics");
    visit("foot_slip_noise_mps", self.foot_slip_noise_mps, Range{1e-6, 10.0},
          "assumed random walk of a standing foot");
    visit("foot_turn_doubt_radps", self.foot_turn_doubt_radps, Range{1e-3, 1e6},
          "a sole that turns so fast as it stands doubles both deviations of its velocity");
    visit("floor_noise_m", self.floor_noise_m, Range{0.0, 1.0},
          "assumed standard deviation of the floor's height from one foothold to another, whose "
          "heights are learned (0: the floor is level)");
    visit("contact_threshold_N", self.contact_threshold_N, Range{0.0, 1e4},
          "ground force above which a foot counts as in contact");
    visit("wrench_cutoff_hz", self.wrench_cutoff_hz, Range{0.1, 1e4},
          "low-pass of the external wrench measured in the arms");
    visit("wrench_deadband_N", self.wrench_deadband_N, Range{0.0, 1e3},
          "a measured force below this is taken for none");
    visit("push_cutoff_hz", self.push_cutoff_hz, Range{0.0, 1e3},
          "low-pass of pushes felt by the momentum; needs force/torque sensors in the feet (0: not "
          "felt)");
    visit("push_deadband_N", self.push_deadband_N, Range{0.0, 1e3},
          "a push felt by the momentum below this is taken for none");
    visit("push_settle_s", self.push_settle_s, Range{0.0, 1.0},
          "for so long after a foot has landed the momentum tells of no push");
    visit("push_decay_s", self.push_decay_s, Range{1e-3, 10.0},
          "time constant with which a push felt before fades meanwhile");
    visit("push_limit_ratio", self.push_limit_ratio, Range{0.0, 100.0},
          "largest push that the momentum may tell of, over the robot's weight");
  }
};

/// The controller's settings as one value: with the robot, the gait and the length of a tick
/// (ControllerSetup) they decide all that it does.
/// Periods nest: 1 / rate_hz is a whole number of physics steps, 1 / mpc.rate_hz a whole number of
/// control periods (sim/scenario/check_scenario). Of inverse_dynamics and inverse_kinematics the
/// one that `mode` names is read, and neither on the centroidal plant. kPassive reads none of the
/// blocks.
struct ControlParams {
  ControlMode mode{ControlMode::kTorque};  ///< Torque needs limited motors; position needs servos.
  double rate_hz{500.0};                   ///< Of the whole chain but the MPC, which has its own.
  ExternalWrenchKnowledge external_wrench{ExternalWrenchKnowledge::kUnknown};
  EstimatorKind estimator{EstimatorKind::kSensors};
  PlannerParams planner;
  Stepping stepping{Stepping::kMpc};
  MpcParams mpc;
  DcmParams dcm;  ///< Counts unless `stepping` is kMpc.
  InverseDynamicsParams inverse_dynamics;
  InverseKinematicsParams inverse_kinematics;
  EstimatorParams estimation;

  template <typename Self, typename Visitor>
  static void VisitFields(Self& self, Visitor&& visit) {
    visit("mode", self.mode,
          "torque: inverse dynamics; position: inverse kinematics and the servos of the joints; "
          "passive: does nothing, the negative control");
    visit("rate_hz", self.rate_hz, Range{1.0, 10000.0}, "control ticks a second");
    visit("external_wrench", self.external_wrench,
          "what the controller knows of a push: unknown: only what it does to the state; "
          "estimated: what arms and momentum feel; known: all, from the simulation");
    visit("estimator", self.estimator, "sensors, or truth: the exact state");
    visit("planner", self.planner, "how the nominal path follows a pushed robot");
    visit("stepping", self.stepping,
          "what plans CoM, forces and steps: mpc; or a baseline to compare with: dcm_qp: place and "
          "time of the step by a QP; capture_point: to the capture point, by the clock");
    visit("mpc", self.mpc, "the model predictive control of CoM, footholds and forces");
    visit("dcm", self.dcm, "of the baselines dcm_qp and capture_point");
    visit("inverse_dynamics", self.inverse_dynamics, "gains and weights of mode torque");
    visit("inverse_kinematics", self.inverse_kinematics, "gains and weights of mode position");
    visit("estimation", self.estimation,
          "noise that the estimator assumes, and what it feels of pushes");
  }
};

}  // namespace sidestep
