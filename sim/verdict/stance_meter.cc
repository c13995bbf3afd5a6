// SPDX-License-Identifier: BSD-3-Clause
#include "sim/verdict/stance_meter.h"

namespace sidestep {
namespace {

constexpr double kSettle_s = 0.01;  // After touch-down; a compliant contact rings shorter.

}  // namespace

void StanceMeter::Add(Tick tick, const FootTruth& foot) {
  bears_load_ = foot.in_contact && foot.f_F_W.z() > min_load_N_;
  if (bears_load_ && !stands_) {
    stands_ = true;
    ++num_stances_;
    start_tick_ = tick;
  }
  if (!stands_) return;
  if (foot.in_contact) last_contact_tick_ = tick;
  if (tick - last_contact_tick_ > TickAt(kBounce_s, tick_s_)) stands_ = false;
  is_settled_ = tick - start_tick_ >= TickAt(kSettle_s, tick_s_);
}

}  // namespace sidestep
