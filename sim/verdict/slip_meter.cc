// SPDX-License-Identifier: BSD-3-Clause
#include "sim/verdict/slip_meter.h"

#include <algorithm>

namespace sidestep {

void SlipMeter::Add(const FootTruth& foot, const StanceMeter& stance) {
  if (!stance.stands() || stance.num_stances() != stance_) {
    stance_ = stance.num_stances();
    anchor_W_.reset();
    stance_slip_m_ = 0.0;
  }
  if (!stance.stands() || !stance.bears_settled_load()) return;
  if (!anchor_W_) anchor_W_ = foot.p_WF.head<2>();
  stance_slip_m_ = std::max(stance_slip_m_, (foot.p_WF.head<2>() - *anchor_W_).norm());
  max_slip_m_ = std::max(max_slip_m_, stance_slip_m_);
}

}  // namespace sidestep
