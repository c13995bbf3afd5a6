// SPDX-License-Identifier: BSD-3-Clause
#include "sim/world/pushes.h"

#include <cmath>
#include <numbers>
#include <utility>

#include "models/support/require.h"

namespace sidestep {

double PushShare(const Push& push, Tick tick, double tick_s) {
  const Tick start = TickAt(push.start_s, tick_s);
  const Tick end = TickAt(push.start_s + push.duration_s, tick_s);
  if (tick < start || tick >= end) return 0.0;
  if (push.profile == PushProfile::kConstant) return 1.0;
  // The middle of the tick, so that the sum over ticks is the integral to second order.
  const double phase = (static_cast<double>(tick - start) + 0.5) / static_cast<double>(end - start);
  return std::sin(std::numbers::pi * phase);
}

double HeadingRad(const Eigen::Quaterniond& q_WB) {
  const Eigen::Vector3d x_W = q_WB * Eigen::Vector3d::UnitX();
  return std::atan2(x_W.y(), x_W.x());
}

Pushes::Pushes(std::vector<Push> pushes, double tick_s)
    : pushes_(std::move(pushes)),
      tick_s_(tick_s),
      latches_(pushes_.size()),
      acting_(pushes_.size()) {
  SIDESTEP_REQUIRE(tick_s > 0.0, tick_s);
}

const std::vector<PushTruth>& Pushes::Update(Tick tick, std::span<const PushedPose> poses,
                                             double heading_rad) {
  SIDESTEP_REQUIRE(poses.size() == pushes_.size(), poses.size());
  for (std::size_t i = 0; i < pushes_.size(); ++i) {
    const Push& push = pushes_[i];
    Latch& latch = latches_[i];
    const double share = PushShare(push, tick, tick_s_);
    const bool acts = share != 0.0;
    if (acts && !latch.has_started) latch = {true, heading_rad};

    Eigen::Vector3d force_W_N = push.force_N;
    if (push.frame == PushFrame::kHeading) {
      force_W_N = Eigen::AngleAxisd(latch.heading_rad, Eigen::Vector3d::UnitZ()) * push.force_N;
    } else if (push.frame == PushFrame::kBody) {
      force_W_N = poses[i].R_WO * push.force_N;
    }
    acting_[i].force_W_N = acts ? (share * force_W_N).eval() : Eigen::Vector3d::Zero().eval();
    acting_[i].p_W = poses[i].p_WO + poses[i].R_WO * push.point_m;
  }
  return acting_;
}

}  // namespace sidestep
