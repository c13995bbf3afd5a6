// SPDX-License-Identifier: BSD-3-Clause
#include "sim/verdict/joint_meter.h"

#include <algorithm>
#include <cmath>

#include "models/support/require.h"

namespace sidestep {

JointMeter::JointMeter(const std::vector<JointInfo>& joints,
                       const std::vector<JointDescription>& described, double tick_s)
    : tick_s_(tick_s) {
  const bool is_described = described.size() == joints.size();
  SIDESTEP_REQUIRE(is_described || described.empty() || joints.empty(), described.size());
  for (std::size_t i = 0; i < joints.size(); ++i) {
    JointRecord& record = records_.emplace_back();
    record.joint = joints[i];
    if (!is_described || joints[i].is_slide) continue;
    const double limit_radps = described[i].velocity_limit_radps;
    if (limit_radps > 0.0) record.speed_limit_radps = limit_radps;
  }
}

void JointMeter::Add(const WorldTruth& truth) {
  if (truth.num_saturated > 0) saturation_s_ += tick_s_;
  if (truth.joint_position.size() == 0) return;
  const auto joints = static_cast<Eigen::Index>(records_.size());
  SIDESTEP_REQUIRE(truth.joint_position.size() == joints, truth.joint_position.size());
  SIDESTEP_REQUIRE(truth.joint_velocity.size() == joints, truth.joint_velocity.size());
  SIDESTEP_REQUIRE(truth.joint_torque_Nm.size() == joints, truth.joint_torque_Nm.size());
  for (Eigen::Index i = 0; i < joints; ++i) {
    JointRecord& record = records_[static_cast<std::size_t>(i)];
    const JointInfo& joint = record.joint;
    const double torque_Nm = std::abs(truth.joint_torque_Nm[i]);
    const double speed = std::abs(truth.joint_velocity[i]);
    record.peak_torque_Nm = std::max(record.peak_torque_Nm, torque_Nm);
    record.peak_speed_radps = std::max(record.peak_speed_radps, speed);
    // fmin and fmax drop the NaN that stands for nothing measured yet.
    if (std::isfinite(joint.torque_limit_Nm)) {
      max_torque_ratio_ = std::fmax(max_torque_ratio_, torque_Nm / joint.torque_limit_Nm);
    }
    if (std::isfinite(record.speed_limit_radps)) {
      max_speed_ratio_ = std::fmax(max_speed_ratio_, speed / record.speed_limit_radps);
    }
    const double margin = std::min(truth.joint_position[i] - joint.position_min,
                                   joint.position_max - truth.joint_position[i]);
    if (!joint.is_slide && std::isfinite(margin)) {
      min_margin_rad_ = std::fmin(min_margin_rad_, margin);
    }
  }
}

}  // namespace sidestep
