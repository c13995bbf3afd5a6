// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// truth_estimator: estimators that are told the state: `estimator: truth`, and the centroidal
// plant.

#include "controller/estimator/force_sensing.h"
#include "controller/estimator/momentum_observer.h"
#include "controller/estimator/state_estimator.h"
#include "controller/model/rigid_body.h"
#include "controller/types/control_params.h"

namespace sidestep {

/// Believes SensorFrame::truth. For comparison with LegOdometry only.
class TruthEstimator final : public StateEstimator {
 public:
  /// `rigid_body` must outlive the estimator; Update() leaves its kinematics
  /// at the new state.
  /// `dt_s` is the time between frames.
  TruthEstimator(const RobotDescription& robot, const EstimatorParams& params, double dt_s,
                 RigidBody* rigid_body);
  const RobotState& Update(const SensorFrame& frame) override;

 private:
  RigidBody* rigid_body_;
  ForceSensing forces_;
  MomentumObserver observer_;
  RobotState state_;
};

/// Believes SensorFrame::centroidal, the reduced state that the centroidal plant measures.
class CentroidalEstimator final : public StateEstimator {
 public:
  CentroidalEstimator(int num_feet, double mass_kg, double contact_threshold_N);
  const RobotState& Update(const SensorFrame& frame) override;

 private:
  double mass_kg_;
  double contact_threshold_N_;
  RobotState state_;
};

}  // namespace sidestep
