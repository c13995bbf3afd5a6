// SPDX-License-Identifier: BSD-3-Clause
#include "sim/sensors/sensor_suite.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "models/support/require.h"
#include "sim/scenario/scenario.h"

namespace sidestep {
namespace {

// Sets the draws of the biases apart from those of the noise: 2^64 over the golden ratio.
constexpr std::uint64_t kBiasStream = 0x9E3779B97F4A7C15U;

std::size_t NumFrames(double delay_s, double rate_hz) {
  return static_cast<std::size_t>(std::llround(delay_s * rate_hz));
}

Eigen::VectorXd DrawBiases(std::uint64_t seed, double deviation, Eigen::Index size) {
  std::mt19937_64 random(seed ^ kBiasStream);
  std::normal_distribution<double> normal(0.0, 1.0);
  Eigen::VectorXd biases(size);
  for (double& bias : biases) bias = deviation * normal(random);
  return biases;
}

}  // namespace

SensorSuite::SensorSuite(SensorSetup setup)
    : setup_(std::move(setup)),
      delay_frames_(NumFrames(setup_.errors.delay_s, setup_.rate_hz)),
      wrench_delay_frames_(NumFrames(setup_.errors.wrench_delay_s, setup_.rate_hz)),
      random_(setup_.seed) {
  SIDESTEP_REQUIRE(setup_.rate_hz > 0.0, setup_.rate_hz);
}

double SensorSuite::Noise(double deviation) {
  return deviation > 0.0 ? deviation * normal_(random_) : 0.0;
}

Eigen::Vector3d SensorSuite::Noise3(double deviation) {
  const double x = Noise(deviation);
  const double y = Noise(deviation);
  const double z = Noise(deviation);
  return {x, y, z};
}

SensorFrame SensorSuite::Sample(const WorldTruth& truth) {
  SensorFrame frame;
  const Eigen::Vector3d tilt_rad = Noise3(setup_.errors.orientation_noise_rad);
  frame.imu.q_WU = truth.imu.q_WU * Eigen::Quaterniond(1.0, 0.5 * tilt_rad.x(), 0.5 * tilt_rad.y(),
                                                       0.5 * tilt_rad.z());
  frame.imu.q_WU.normalize();
  frame.imu.gyro_radps =
      truth.imu.gyro_radps + setup_.errors.gyro_bias_radps + Noise3(setup_.errors.gyro_noise_radps);
  const Eigen::Vector3d specific_force_mps2 =
      num_accumulated_ > 0 ? truth.imu.q_WU.conjugate() * mean_specific_force_W_mps2_
                           : truth.imu.accelerometer_mps2;
  frame.imu.accelerometer_mps2 = specific_force_mps2 + setup_.errors.accelerometer_bias_mps2 +
                                 Noise3(setup_.errors.accelerometer_noise_mps2);
  SampleJoints(truth, &frame);
  SampleFeet(truth, &frame);
  SampleForceTorque(truth, &frame);
  num_accumulated_ = 0;
  AddPermittedTruth(truth, &frame);
  return frame;
}

void SensorSuite::SampleJoints(const WorldTruth& truth, SensorFrame* frame) {
  const Eigen::Index joints = truth.joint_position.size();
  if (encoder_bias_.size() != joints) {
    encoder_bias_ = DrawBiases(setup_.seed, setup_.errors.encoder_bias_rad, joints);
  }
  frame->joint_position = truth.joint_position + encoder_bias_;
  frame->joint_velocity = truth.joint_velocity;
  for (Eigen::Index i = 0; i < joints; ++i) {
    frame->joint_position[i] += Noise(setup_.errors.encoder_noise_rad);
    frame->joint_velocity[i] += Noise(setup_.errors.encoder_velocity_noise_radps);
  }
}

void SensorSuite::SampleFeet(const WorldTruth& truth, SensorFrame* frame) {
  SIDESTEP_REQUIRE(truth.feet.size() == setup_.has_touch.size(), truth.feet.size());
  for (std::size_t i = 0; i < setup_.has_touch.size(); ++i) {
    FootSample sample;
    if (setup_.has_touch[i]) {
      sample.normal_force_N =
          std::max(0.0, truth.feet[i].touch_N + Noise(setup_.errors.touch_noise_N));
    }
    frame->feet.push_back(sample);
  }
}

void SensorSuite::Accumulate(const WorldTruth& truth) {
  if (num_accumulated_ == 0) {
    mean_wrenches_.assign(truth.force_torque.size(), Wrench{});
    mean_specific_force_W_mps2_.setZero();
  }
  ++num_accumulated_;
  const Eigen::Vector3d specific_force_W_mps2 = truth.imu.q_WU * truth.imu.accelerometer_mps2;
  mean_specific_force_W_mps2_ +=
      (specific_force_W_mps2 - mean_specific_force_W_mps2_) / num_accumulated_;
  for (std::size_t i = 0; i < mean_wrenches_.size(); ++i) {
    Wrench& mean = mean_wrenches_[i];
    mean.force_N += (truth.force_torque[i].force_N - mean.force_N) / num_accumulated_;
    mean.torque_Nm += (truth.force_torque[i].torque_Nm - mean.torque_Nm) / num_accumulated_;
  }
}

void SensorSuite::SampleForceTorque(const WorldTruth& truth, SensorFrame* frame) {
  std::vector<Wrench> now = num_accumulated_ > 0 ? mean_wrenches_ : truth.force_torque;
  for (Wrench& wrench : now) {
    wrench.force_N += setup_.errors.force_bias_N + Noise3(setup_.errors.force_noise_N);
    wrench.torque_Nm += Noise3(setup_.errors.torque_noise_Nm);
  }
  wrenches_in_transit_.push_back(std::move(now));
  frame->force_torque = wrenches_in_transit_.front();
  frame->force_torque_age_s = static_cast<double>(wrenches_in_transit_.size() - 1) / setup_.rate_hz;
  if (wrenches_in_transit_.size() > wrench_delay_frames_) wrenches_in_transit_.pop_front();
}

void SensorSuite::AddPermittedTruth(const WorldTruth& truth, SensorFrame* frame) const {
  if (setup_.permitted.base_state)
    frame->truth = {truth.p_WB, truth.q_WB, truth.v_WB, truth.w_WB_B};
  if (setup_.permitted.centroidal_state) {
    CentroidalSample sample{truth.p_WC, setup_.mass_kg * truth.v_WC, truth.angular_momentum, {}};
    for (const FootTruth& foot : truth.feet) sample.p_WF.push_back(foot.p_WF);
    frame->centroidal = std::move(sample);
  }
  if (setup_.permitted.external_wrench) {
    Wrench wrench;
    for (const PushTruth& push : truth.pushes) {
      wrench.force_N += push.force_W_N;
      wrench.torque_Nm += (push.p_W - truth.p_WC).cross(push.force_W_N);
    }
    frame->known_external_wrench = wrench;
  }
}

SensorFrame SensorSuite::Read(const WorldTruth& truth, Tick tick) {
  in_transit_.push_back(Sample(truth));
  // Until the first delayed frame arrives, the oldest there is stands in for it.
  SensorFrame arriving = in_transit_.front();
  if (in_transit_.size() > delay_frames_) in_transit_.pop_front();
  const bool drops = setup_.errors.dropout > 0.0 && uniform_(random_) < setup_.errors.dropout;
  if (!drops || !has_last_) {
    last_ = std::move(arriving);
    has_last_ = true;
  }
  last_.tick = tick;
  return last_;
}

SensorSuite MakeSensorSuite(const Scenario& scenario, double mass_kg) {
  SensorSetup setup;
  setup.errors = scenario.sensors;
  setup.permitted.base_state = scenario.control.estimator == EstimatorKind::kTruth;
  setup.permitted.centroidal_state = scenario.plant == Plant::kCentroidal;
  setup.permitted.external_wrench =
      scenario.control.external_wrench == ExternalWrenchKnowledge::kKnown;
  setup.rate_hz = scenario.control.rate_hz;
  setup.seed = scenario.seed;
  setup.mass_kg = mass_kg;
  for (const FootDescription& foot : scenario.robot.feet) {
    setup.has_touch.push_back(foot.force_torque.empty());
  }
  return SensorSuite(std::move(setup));
}

}  // namespace sidestep
