// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// wild_targets: targets for the inverse kinematics that nobody in his right mind would give, and
// sane ones between them; the same on every machine.

#include <cstdint>

#include "tests/support/icub3_stance.h"
#include "tests/support/random_dense_qp.h"

namespace sidestep::wbc {

class WildTargets {
 public:
  WildTargets(std::uint64_t seed, IcubStance* stance)
      : numbers_(seed), stance_(stance), home_(stance->state), home_feet_(stance->feet) {}

  /// Draws the belief and the targets of the next tick. Wildness changes every 15 ticks.
  void Next() {
    if (tick_++ % 15 != 0) return;
    const double scale = numbers_.Uniform(0.0, 1.0) < 0.5 ? 0.02 : 1.0;
    stance_->com.v_WC = numbers_.Vector3(3.0 * scale);
    stance_->com.p_WC = home_.p_WC + numbers_.Vector3(0.3 * scale);
    stance_->state.p_WC = home_.p_WC + numbers_.Vector3(0.05 * scale);
    stance_->state.p_WB = home_.p_WB + numbers_.Vector3(0.1 * scale);
    stance_->state.q_WB = numbers_.Turn(0.5 * scale) * home_.q_WB;
    const int swinging = numbers_.Integer(0, 2);  // or none
    for (int i = 0; i < 2; ++i) {
      const auto at = static_cast<std::size_t>(i);
      FootState& foot = stance_->state.feet[at];
      foot.p_WF = home_.feet[at].p_WF + numbers_.Vector3(0.05 * scale);
      foot.in_contact = i != swinging || numbers_.Uniform(0.0, 1.0) < 0.2;
      foot.wrench = {numbers_.Vector3(100.0) + Eigen::Vector3d(0.0, 0.0, 250.0),
                     numbers_.Vector3(20.0)};
      FootTarget& target = stance_->feet[at];
      target.planned_contact = target.supports = i != swinging;
      target.p_WF = home_feet_[at].p_WF + numbers_.Vector3(0.3 * scale);
      target.v_WF = numbers_.Vector3(2.0 * scale);
      target.contact.R_WF = numbers_.Turn(0.3 * scale).toRotationMatrix();
      target.vertex_force_N = 60.0 * Eigen::Matrix3Xd::Ones(3, target.vertex_force_N.cols());
    }
  }

 private:
  SeededNumbers numbers_;
  IcubStance* stance_;
  RobotState home_;
  std::vector<FootTarget> home_feet_;
  int tick_{0};
};

}  // namespace sidestep::wbc
