// SPDX-License-Identifier: BSD-3-Clause
#include "controller/swing/swing_foot.h"

#include <algorithm>

namespace sidestep {
namespace {

constexpr double kFreeze_s = 0.03;  // the foothold no longer moves this long before landing
constexpr double kHole_m =
    0.01;  // a foot that stood lower than that below its next place was in one

// Value after `elapsed_s` on the way from `from` to `to` in `remaining_s`.
QuinticState Follow(const QuinticState& from, const QuinticState& to, double remaining_s,
                    double elapsed_s) {
  if (elapsed_s >= remaining_s) return to;
  return Quintic(from, to, remaining_s).At(elapsed_s);
}

}  // namespace

void SwingFoot::LiftOff(const SwingShape& shape, const Eigen::Vector3d& p_WF, Tick tick) {
  shape_ = shape;
  lift_off_tick_ = tick_ = landing_tick_ = tick;
  lift_off_height_m_ = p_WF.z();
  target_p_WF_ = p_WF;
  x_ = {p_WF.x(), 0.0, 0.0};
  y_ = {p_WF.y(), 0.0, 0.0};
  z_ = {p_WF.z(), 0.0, 0.0};
}

void SwingFoot::Update(const Eigen::Vector3d& p_WF_target, Tick landing_tick, Tick tick) {
  const double remaining_s = SecondsAt(landing_tick - tick_, tick_s_);
  const double elapsed_s = SecondsAt(tick - tick_, tick_s_);
  if (remaining_s > kFreeze_s || lift_off_tick_ == tick_) target_p_WF_ = p_WF_target;
  const bool is_in_a_hole =
      lift_off_height_m_ < target_p_WF_.z() - kHole_m && z_.position < target_p_WF_.z();
  if (!is_in_a_hole || tick >= landing_tick) {
    x_ = Follow(x_, {target_p_WF_.x(), 0.0, 0.0}, remaining_s, elapsed_s);
    y_ = Follow(y_, {target_p_WF_.y(), 0.0, 0.0}, remaining_s, elapsed_s);
  }
  UpdateHeight(landing_tick, tick);
  tick_ = tick;
}

void SwingFoot::UpdateHeight(Tick landing_tick, Tick tick) {
  if (tick >= landing_tick) {
    z_ = HeightBelow(target_p_WF_.z(), tick - landing_tick);
    return;
  }
  const Tick apex_tick = lift_off_tick_ + (landing_tick - lift_off_tick_) / 2;
  const double elapsed_s = SecondsAt(tick - tick_, tick_s_);
  if (tick <= apex_tick) {
    const double rise_s = SecondsAt(apex_tick - tick_, tick_s_);
    if (landing_tick != landing_tick_) {  // once, for the bound on the way is a wider one
      landing_tick_ = landing_tick;
      highest_m_ = z_.position + 0.5 * z_.velocity * rise_s + limits_.ReachIn(rise_s);
    }
    const double apex_m = std::max(lift_off_height_m_, target_p_WF_.z()) + shape_.height_m;
    z_ = Follow(z_, {std::min(apex_m, highest_m_), 0.0, 0.0}, rise_s, elapsed_s);
  } else {
    z_ = Follow(z_, {target_p_WF_.z(), -shape_.landing_speed_mps, 0.0},
                SecondsAt(landing_tick - tick_, tick_s_), elapsed_s);
  }
}

void SwingFoot::GoDown(const Eigen::Vector3d& p_WF, Tick lost_tick, Tick tick) {
  x_ = {p_WF.x(), 0.0, 0.0};
  y_ = {p_WF.y(), 0.0, 0.0};
  z_ = HeightBelow(p_WF.z(), tick - lost_tick);
  tick_ = tick;
}

// Looking for the floor since `late` ticks.
QuinticState SwingFoot::HeightBelow(double height_m, Tick late) const {
  const double late_s = SecondsAt(late, tick_s_);
  const double gained_mps = search_.acceleration_mps2 * late_s;
  const double depth_m = (shape_.landing_speed_mps + 0.5 * gained_mps) * late_s;
  if (depth_m >= search_.depth_m) return {height_m - search_.depth_m, 0.0, 0.0};
  return {height_m - depth_m, -shape_.landing_speed_mps - gained_mps, -search_.acceleration_mps2};
}

Eigen::Vector3d SwingFoot::position() const { return {x_.position, y_.position, z_.position}; }
Eigen::Vector3d SwingFoot::velocity() const { return {x_.velocity, y_.velocity, z_.velocity}; }
Eigen::Vector3d SwingFoot::acceleration() const {
  return {x_.acceleration, y_.acceleration, z_.acceleration};
}

}  // namespace sidestep
