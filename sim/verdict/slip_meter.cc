// SPDX-License-Identifier: BSD-3-Clause
#include "sim/verdict/slip_meter.h"

#include <algorithm>

namespace sidestep {
namespace {

constexpr double kSettle_s = 0.01;  // After touch-down; a compliant contact rings shorter.
constexpr double kBounce_s = 0.01;  // A shorter loss of contact belongs to the stance.

}  // namespace

SlipMeter::SlipMeter(double tick_s, double min_load_N) : tick_s_(tick_s), min_load_N_(min_load_N) {}

void SlipMeter::Add(Tick tick, const FootTruth& foot, bool planned_contact) {
  if (!foot.in_contact || !planned_contact) {
    if (stance_start_tick_ && tick - last_contact_tick_ > TickAt(kBounce_s, tick_s_)) {
      stance_start_tick_.reset();
      anchor_W_.reset();
      stance_slip_m_ = 0.0;
    }
    return;
  }
  if (!stance_start_tick_) stance_start_tick_ = tick;
  last_contact_tick_ = tick;
  const bool is_settled = tick - *stance_start_tick_ >= TickAt(kSettle_s, tick_s_);
  if (!is_settled || foot.f_F_W.z() <= min_load_N_) return;
  if (!anchor_W_) anchor_W_ = foot.p_WF.head<2>();
  stance_slip_m_ = std::max(stance_slip_m_, (foot.p_WF.head<2>() - *anchor_W_).norm());
  max_slip_m_ = std::max(max_slip_m_, stance_slip_m_);
}

}  // namespace sidestep
