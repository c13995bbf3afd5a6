// SPDX-License-Identifier: BSD-3-Clause
#include "controller/push_alarm.h"

#include <cmath>

#include "controller/planner/capture_point.h"

namespace sidestep {
namespace {

constexpr double kMemory_s = 0.2;  // of what was unforeseen; about a pendulum's time constant

}  // namespace

PushAlarm::PushAlarm(double error_m, double alert_s, double height_m, double mass_kg, double tick_s)
    : error_m_(error_m),
      height_m_(height_m),
      mass_kg_(mass_kg),
      tick_s_(tick_s),
      alert_(TickAt(alert_s, tick_s)) {}

bool PushAlarm::Update(const RobotState& state, const ComTarget& planned, Tick tick) {
  const ComReference plan{planned.p_WC, planned.v_WC, planned.a_WC};
  unforeseen_m_ *= std::exp(-SecondsAt(tick - last_, tick_s_) / kMemory_s);
  unforeseen_m_ += CapturePointError(state, plan, height_m_);
  last_ = tick;
  const double time_constant_s = PendulumTimeConstant_s(height_m_);
  Eigen::Vector3d felt_m =
      state.external_wrench.force_N * time_constant_s * time_constant_s / mass_kg_;
  felt_m.z() = 0.0;
  if ((unforeseen_m_ + felt_m).norm() > error_m_) noticed_ = tick;
  return noticed_ && tick - *noticed_ <= alert_;
}

}  // namespace sidestep
