// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// moving_com: runs of robots whose CoM moves as a test wants, with pushes that push nothing.

#include <Eigen/Core>
#include <functional>

#include "tests/unit/verdict/verdict_test_support.h"

namespace sidestep {

/// Appends a push; what it does is the test's affair.
inline void PushAt(Scenario& scenario, double start_s, double duration_s) {
  Push push;
  push.start_s = start_s;
  push.duration_s = duration_s;
  scenario.pushes.push_back(push);
}

/// A robot of two feet that is to walk at 0.5 m/s without sway; one push from 4.0 s to 4.5 s.
inline Scenario PushedWalkScenario() {
  Scenario scenario = TwoFeetScenario();
  scenario.gait[0].step_length_m = 0.4;
  PushAt(scenario, 4.0, 0.5);
  return scenario;
}

/// Where the CoM is (m, W).
using ComOf = std::function<Eigen::Vector3d(double time_s)>;

/// The run of a robot whose CoM moves like that, for `end_s`.
inline RunOutcome RunOf(const Scenario& scenario, double end_s, const ComOf& com) {
  return OutcomeOf(scenario, TickAt(end_s, 0.001), [&](Tick tick, WorldTruth& truth, ControlTick&) {
    truth.p_WC = com(0.001 * static_cast<double>(tick));
  });
}

/// The nominal motion, late by so much.
inline ComOf NominalLate(const Scenario& scenario, const std::function<double(double)>& late_s_at) {
  return [nominal = NominalOf(scenario), late_s_at](double time_s) {
    return nominal.ComAt(TickAt(time_s - late_s_at(time_s), 0.001)).p_WC;
  };
}

}  // namespace sidestep
