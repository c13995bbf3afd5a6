// SPDX-License-Identifier: BSD-3-Clause
#include "sim/sensors/sensor_suite.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace sidestep {

SensorSuite::SensorSuite(const Scenario& scenario, double mass_kg)
    : params_(scenario.sensors),
      is_centroidal_(scenario.plant == Plant::kCentroidal),
      tells_truth_(scenario.control.estimator == EstimatorKind::kTruth),
      tells_push_(scenario.control.external_wrench == ExternalWrenchKnowledge::kKnown),
      mass_kg_(mass_kg),
      delay_frames_(static_cast<std::size_t>(
          std::llround(scenario.sensors.delay_s * scenario.control.rate_hz))),
      random_(scenario.seed) {}

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
  const Eigen::Vector3d tilt_rad = Noise3(params_.orientation_noise_rad);
  frame.imu.q_WU = truth.imu.q_WU * Eigen::Quaterniond(1.0, 0.5 * tilt_rad.x(), 0.5 * tilt_rad.y(),
                                                       0.5 * tilt_rad.z());
  frame.imu.q_WU.normalize();
  frame.imu.gyro_radps = truth.imu.gyro_radps + Noise3(params_.gyro_noise_radps);
  frame.imu.accelerometer_mps2 =
      truth.imu.accelerometer_mps2 + Noise3(params_.accelerometer_noise_mps2);
  frame.joint_position = truth.joint_position;
  frame.joint_velocity = truth.joint_velocity;
  for (Eigen::Index i = 0; i < frame.joint_position.size(); ++i) {
    frame.joint_position[i] += Noise(params_.encoder_noise_rad);
    frame.joint_velocity[i] += Noise(params_.encoder_velocity_noise_radps);
  }
  for (const FootTruth& foot : truth.feet) {
    const double force_N = foot.touch_N + Noise(params_.touch_noise_N);
    frame.feet.push_back({std::max(0.0, force_N)});
  }
  if (tells_truth_) frame.truth = {truth.p_WB, truth.q_WB, truth.v_WB, truth.w_WB_B};
  if (is_centroidal_) {
    CentroidalSample sample{truth.p_WC, mass_kg_ * truth.v_WC, truth.angular_momentum, {}};
    for (const FootTruth& foot : truth.feet) sample.p_WF.push_back(foot.p_WF);
    frame.centroidal = std::move(sample);
  }
  if (tells_push_) {
    Wrench wrench;
    for (const PushTruth& push : truth.pushes) {
      wrench.force_N += push.force_W_N;
      wrench.torque_Nm += (push.p_W - truth.p_WC).cross(push.force_W_N);
    }
    frame.known_external_wrench = wrench;
  }
  return frame;
}

SensorFrame SensorSuite::Read(const WorldTruth& truth, Tick tick) {
  in_transit_.push_back(Sample(truth));
  // Until the first delayed frame arrives, the oldest there is stands in for it.
  SensorFrame arriving = in_transit_.front();
  if (in_transit_.size() > delay_frames_) in_transit_.pop_front();
  const bool drops = params_.dropout > 0.0 && uniform_(random_) < params_.dropout;
  if (!drops || !has_last_) {
    last_ = std::move(arriving);
    has_last_ = true;
  }
  last_.tick = tick;
  return last_;
}

}  // namespace sidestep
