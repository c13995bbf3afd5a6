// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// truth_estimator: estimators that are told the state: `estimator: truth`, and the centroidal
// plant.

#include <memory>

#include "controller/estimator/external_wrench.h"
#include "controller/estimator/force_sensing.h"
#include "controller/estimator/state_estimator.h"
#include "controller/model/rigid_body.h"
#include "controller/types/control_params.h"

namespace sidestep {

/// Believes SensorFrame::truth. For comparison with LegOdometry only.
/// Base from the truth, joints, contacts and wrenches from the sensors as in LegOdometry: what a
/// perfect odometry would give.
class TruthEstimator final : public StateEstimator {
 public:
  /// `dt_s` is the time between frames; `body` is the robot, for its sizes and mass.
  TruthEstimator(const RobotDescription& robot, const EstimatorParams& params,
                 ExternalWrenchKnowledge external_wrench, double dt_s, const RigidBody& body);

  /// Throws ContractViolation if the frame carries no truth.
  const RobotState& Update(const SensorFrame& frame, RigidBody* body) override;
  std::unique_ptr<StateEstimator> Clone() const override;

 private:
  ForceSensing forces_;
  ExternalWrench external_wrench_;
  RobotState state_;
};

/// Believes SensorFrame::centroidal, the reduced state that the centroidal plant measures: there is
/// no rigid body to derive anything from.
class CentroidalEstimator {
 public:
  /// A foot stands if it is pressed by more than `contact_threshold_N`.
  CentroidalEstimator(int num_feet, double mass_kg, double contact_threshold_N,
                      ExternalWrenchKnowledge external_wrench);

  /// Takes the next frame and returns the belief at its instant. The reference stays valid; the
  /// object behind it changes with the next call. Throws ContractViolation if the frame carries no
  /// centroidal sample.
  const RobotState& Update(const SensorFrame& frame);

 private:
  double mass_kg_;
  double contact_threshold_N_;
  ExternalWrench external_wrench_;
  RobotState state_;
};

}  // namespace sidestep
