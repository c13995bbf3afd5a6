// SPDX-License-Identifier: BSD-3-Clause
#include "sim/verdict/joint_meter.h"

#include <algorithm>
#include <cmath>

#include "models/support/require.h"

namespace sidestep {

JointMeter::JointMeter(const std::vector<JointInfo>& joints, double tick_s) : tick_s_(tick_s) {
  for (const JointInfo& joint : joints) records_.push_back({joint, 0.0});
}

void JointMeter::Add(const WorldTruth& truth) {
  if (truth.num_saturated > 0) saturation_s_ += tick_s_;
  if (truth.joint_position.size() == 0) return;
  const auto joints = static_cast<Eigen::Index>(records_.size());
  SIDESTEP_REQUIRE(truth.joint_position.size() == joints, truth.joint_position.size());
  SIDESTEP_REQUIRE(truth.joint_torque_Nm.size() == joints, truth.joint_torque_Nm.size());
  for (Eigen::Index i = 0; i < joints; ++i) {
    JointRecord& record = records_[static_cast<std::size_t>(i)];
    const JointInfo& joint = record.joint;
    const double torque_Nm = std::abs(truth.joint_torque_Nm[i]);
    record.peak_torque_Nm = std::max(record.peak_torque_Nm, torque_Nm);
    // fmin and fmax drop the NaN that stands for nothing measured yet.
    if (std::isfinite(joint.torque_limit_Nm)) {
      max_torque_ratio_ = std::fmax(max_torque_ratio_, torque_Nm / joint.torque_limit_Nm);
    }
    const double margin = std::min(truth.joint_position[i] - joint.position_min,
                                   joint.position_max - truth.joint_position[i]);
    if (!joint.is_slide && std::isfinite(margin)) {
      min_margin_rad_ = std::fmin(min_margin_rad_, margin);
    }
  }
}

}  // namespace sidestep
