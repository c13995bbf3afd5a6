// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// sensor_suite: what the controller gets to see of the truth: noisy, late, sometimes missing.

#include <cstdint>
#include <deque>
#include <random>
#include <vector>

#include "controller/types/sensor_frame.h"
#include "sim/scenario/scenario.h"
#include "sim/world/world.h"

namespace sidestep {

/// The robot's sensors. Deterministic in the scenario's seed.
class SensorSuite {
 public:
  SensorSuite(const Scenario& scenario, double mass_kg);

  /// Takes in a physics step. Force/torque sensors give the mean of the steps since the last
  /// Read(), as their own filters against aliasing do; without any, what acts at the moment.
  void Feel(const WorldTruth& truth);

  /// The frame that arrives at `tick`: the reading of delay_s ago, or the last frame again where
  /// one drops out. Truth and push are in it only as far as the scenario lets the controller know.
  SensorFrame Read(const WorldTruth& truth, Tick tick);

 private:
  SensorFrame Sample(const WorldTruth& truth);
  void SampleJoints(const WorldTruth& truth, SensorFrame* frame);
  void SampleFeet(const WorldTruth& truth, SensorFrame* frame);
  void SampleForceTorque(const WorldTruth& truth, SensorFrame* frame);
  void TellWhatIsKnown(const WorldTruth& truth, SensorFrame* frame) const;
  Eigen::Vector3d Noise3(double deviation);
  double Noise(double deviation);

  SensorParams params_;
  bool is_centroidal_;
  bool tells_truth_;
  bool tells_push_;
  double mass_kg_;
  double control_rate_hz_;
  std::vector<bool> has_touch_;  // of each foot
  std::size_t delay_frames_;
  std::size_t wrench_delay_frames_;
  std::uint64_t seed_;
  std::mt19937_64 random_;
  std::normal_distribution<double> normal_{0.0, 1.0};
  std::uniform_real_distribution<double> uniform_{0.0, 1.0};
  Eigen::VectorXd encoder_bias_;       // of each joint, drawn with the first frame
  std::vector<Wrench> mean_wrenches_;  // of the steps since the last Read()
  int num_felt_{0};                    // those steps
  std::deque<std::vector<Wrench>> wrenches_in_transit_;  // oldest first
  std::deque<SensorFrame> in_transit_;                   // oldest first
  SensorFrame last_;
  bool has_last_{false};
};

}  // namespace sidestep
