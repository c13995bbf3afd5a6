// SPDX-License-Identifier: BSD-3-Clause
#include "sim/world/pushes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "models/support/require.h"
#include "sim/scenario/push_ticks.h"

namespace sidestep {

double PushShare(const Push& push, Tick tick, double tick_s) {
  const PushTicks ticks = TicksOf(push, tick_s);
  const double from = std::max(ticks.start, static_cast<double>(tick));
  const double to = std::min(ticks.end, static_cast<double>(tick + 1));
  if (from >= to) return 0.0;
  if (push.profile == PushProfile::kConstant) return to - from;
  // The integral of sin(pi (t - start) / length) from `from` to `to`.
  const double length = ticks.end - ticks.start;
  const double rate = std::numbers::pi / length;
  return (std::cos(rate * (from - ticks.start)) - std::cos(rate * (to - ticks.start))) / rate;
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
