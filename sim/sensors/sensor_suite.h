// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// sensor_suite: what the controller gets to see of the truth: noisy, late, sometimes missing.

#include <cstdint>
#include <deque>
#include <random>
#include <vector>

#include "controller/types/sensor_frame.h"
#include "sim/scenario/sensor_params.h"
#include "sim/world/world.h"

namespace sidestep {

struct Scenario;

/// Parts of the truth that the controller may know as they are, late as any reading but without
/// error.
struct PermittedTruth {
  bool base_state{false};        ///< SensorFrame::truth.
  bool centroidal_state{false};  ///< SensorFrame::centroidal.
  bool external_wrench{false};   ///< SensorFrame::known_external_wrench.
};

/// What makes a suite.
struct SensorSetup {
  SensorParams errors;
  PermittedTruth permitted;
  double rate_hz{1000.0};       ///< Frames a second, > 0.
  std::uint64_t seed{1};        ///< Decides every error.
  double mass_kg{1.0};          ///< The plant's: its momentum is part of the centroidal state.
  std::vector<bool> has_touch;  ///< One a foot: whether a touch sensor measures its normal force.
};

/// The robot's sensors. Deterministic in the seed. A copy, made at any time, reads on as its
/// original would: the random numbers to come and the frames on their way are part of the value.
class SensorSuite {
 public:
  /// Throws ContractViolation if rate_hz is not above 0.
  explicit SensorSuite(SensorSetup setup);

  /// Takes a physics step into the means that accelerometer and force/torque sensors give: of the
  /// steps since the last Read(). Of the forces their own filters against aliasing make it; the IMU
  /// integrates what it feels and how it turns (delta velocity, strapdown), so that its mean is
  /// taken in W and told in the axes that U has at the end. Without any step a sensor gives what
  /// acts at the moment.
  void Accumulate(const WorldTruth& truth);

  /// The frame that arrives at `tick`: the reading of delay_s ago, or the last frame again where
  /// one drops out. Of the truth it holds what is permitted and no more.
  SensorFrame Read(const WorldTruth& truth, Tick tick);

 private:
  SensorFrame Sample(const WorldTruth& truth);
  void SampleJoints(const WorldTruth& truth, SensorFrame* frame);
  void SampleFeet(const WorldTruth& truth, SensorFrame* frame);
  void SampleForceTorque(const WorldTruth& truth, SensorFrame* frame);
  void AddPermittedTruth(const WorldTruth& truth, SensorFrame* frame) const;
  Eigen::Vector3d Noise3(double deviation);
  double Noise(double deviation);

  SensorSetup setup_;
  std::size_t delay_frames_;
  std::size_t wrench_delay_frames_;
  std::mt19937_64 random_;
  std::normal_distribution<double> normal_{0.0, 1.0};
  std::uniform_real_distribution<double> uniform_{0.0, 1.0};
  Eigen::VectorXd encoder_bias_;       // of each joint, drawn with the first frame
  std::vector<Wrench> mean_wrenches_;  // of the steps since the last Read()
  Eigen::Vector3d mean_specific_force_W_mps2_{Eigen::Vector3d::Zero()};  // likewise
  int num_accumulated_{0};                                               // those steps
  std::deque<std::vector<Wrench>> wrenches_in_transit_;                  // oldest first
  std::deque<SensorFrame> in_transit_;                                   // oldest first
  SensorFrame last_;
  bool has_last_{false};
};

/// The sensors that `scenario` asks for, on a plant of mass `mass_kg`. Here alone their parts are
/// picked out of it.
SensorSuite MakeSensorSuite(const Scenario& scenario, double mass_kg);

}  // namespace sidestep
