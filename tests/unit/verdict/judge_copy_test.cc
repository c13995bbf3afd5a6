// SPDX-License-Identifier: BSD-3-Clause
// A judge that is copied in mid-run: both go on bit for bit, and neither sees the other.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <random>

#include "tests/unit/verdict/verdict_test_support.h"

namespace sidestep::judge_copy_test {
namespace {

constexpr Tick kEnd = 5000;

Scenario PushedWalk() {
  Scenario scenario = TwoFeetScenario();
  scenario.pushes.resize(2);
  scenario.pushes[0].start_s = 1.0;
  scenario.pushes[1].start_s = 3.5;
  for (Push& push : scenario.pushes) push.duration_s = 0.2;
  return scenario;
}

// Something of everything that a judge measures: sway, steps, slides, tilts, forces, failures.
void Show(Judge& judge, const Scenario& scenario, Tick tick, double aside_m) {
  const double time_s = 0.001 * static_cast<double>(tick);
  WorldTruth truth = StandingTruth(scenario);
  truth.p_WC = {0.12 * time_s, aside_m + 0.02 * std::sin(5.0 * time_s), 0.5};
  truth.v_WC = {0.12, 0.1 * std::cos(5.0 * time_s), 0.0};
  truth.q_WB = Eigen::AngleAxisd(0.1 * std::sin(3.0 * time_s), Eigen::Vector3d::UnitX());
  truth.angular_momentum = {0.1 * time_s, 0.0, 0.3};
  truth.actuator_power_W = 2.0 + std::sin(time_s);
  if (tick >= 1000 && tick < 1200) truth.pushes[0].force_W_N.y() = 10.0;
  for (std::size_t i = 0; i < 2; ++i) {
    FootTruth& foot = truth.feet[i];
    const Tick phase = (tick + (i == 0 ? 0 : 800)) % 1600;
    foot.p_WF.x() =
        0.2 * std::floor((time_s + (i == 0 ? 0.0 : 0.8)) / 1.6) + 1e-6 * static_cast<double>(phase);
    foot.p_WF.y() = (i == 0 ? 0.08 : -0.08) + aside_m;
    if (phase < 1000) continue;
    foot.in_contact = false;
    foot.p_WF.z() += 0.03;
    foot.f_F_W.setZero();
  }
  ControlTick control = StandingControl(scenario);
  if (tick % 700 < 20) control.mpc.status = SolveStatus::kIterationLimit;
  judge.Add(tick, truth, tick % kControlPeriod == 0 ? &control : nullptr);
}

bool SameBits(double left, double right) {
  return std::bit_cast<std::uint64_t>(left) == std::bit_cast<std::uint64_t>(right);
}

// Empty if alike, else what differs first.
std::string Difference(const RunOutcome& left, const RunOutcome& right) {
  for (const auto& [name, value] : left.metrics) {
    const MetricValue& other = right.metrics.at(name);
    const bool is_same = std::holds_alternative<bool>(value)
                             ? value == other
                             : SameBits(std::get<double>(value), std::get<double>(other));
    if (!is_same) return name;
  }
  if (left.footsteps.size() != right.footsteps.size()) return "number of footsteps";
  for (std::size_t i = 0; i < left.footsteps.size(); ++i) {
    const FootstepRecord &one = left.footsteps[i], &two = right.footsteps[i];
    if (one.realised_p_WF != two.realised_p_WF || one.slip_m != two.slip_m ||
        one.contact.start_tick != two.contact.start_tick) {
      return "footstep " + std::to_string(i);
    }
  }
  for (std::size_t i = 0; i < left.pushes.size(); ++i) {
    const PushFigures &one = left.pushes[i].figures, &two = right.pushes[i].figures;
    if (left.pushes[i].impulse_W_Ns != right.pushes[i].impulse_W_Ns ||
        one.recovered != two.recovered || one.steps_taken != two.steps_taken ||
        !SameBits(one.recovery_time_s, two.recovery_time_s) ||
        !SameBits(one.peak_tilt_rad, two.peak_tilt_rad) || !SameBits(one.drift_m, two.drift_m)) {
      return "push " + std::to_string(i);
    }
  }
  return left.verdict.verdict_class == right.verdict.verdict_class ? "" : "verdict";
}

TEST(JudgeCopyTest, CopyAtAnyTickGoesOnLikeTheOneThatWasNeverCopied) {
  const Scenario scenario = PushedWalk();
  Judge whole = JudgeOf(scenario);
  for (Tick tick = 0; tick <= kEnd; ++tick) Show(whole, scenario, tick, 0.0);
  const RunOutcome expected = whole.Conclude();
  ASSERT_GT(expected.footsteps.size(), 4u);
  ASSERT_EQ(Difference(expected, expected), "");

  std::mt19937 random(7);  // NOLINT: seeded on purpose
  std::uniform_int_distribution<Tick> any_tick(1, kEnd - 1);
  for (int trial = 0; trial < 4; ++trial) {
    const Tick at = any_tick(random);
    Judge judge = JudgeOf(scenario);
    for (Tick tick = 0; tick < at; ++tick) Show(judge, scenario, tick, 0.0);
    Judge copy(judge);
    // The original goes elsewhere meanwhile, and the copy is none the wiser.
    for (Tick tick = at; tick <= kEnd; ++tick) {
      Show(judge, scenario, tick, 0.3);
      Show(copy, scenario, tick, 0.0);
    }
    EXPECT_EQ(Difference(copy.Conclude(), expected), "") << "copied at tick " << at;
    EXPECT_NE(Difference(judge.Conclude(), expected), "") << "copied at tick " << at;
  }
}

TEST(JudgeCopyTest, AssignmentTakesWhatTheOtherHasSeen) {
  const Scenario scenario = PushedWalk();
  Judge judge = JudgeOf(scenario), other = JudgeOf(scenario);
  for (Tick tick = 0; tick < 3000; ++tick) Show(judge, scenario, tick, 0.0);
  other = judge;
  judge.Invalidate(reason::kError, "because", 3.0);
  EXPECT_TRUE(judge.finished());
  EXPECT_FALSE(other.finished());
  for (Tick tick = 3000; tick <= kEnd; ++tick) Show(other, scenario, tick, 0.0);
  Judge whole = JudgeOf(scenario);
  for (Tick tick = 0; tick <= kEnd; ++tick) Show(whole, scenario, tick, 0.0);
  EXPECT_EQ(Difference(other.Conclude(), whole.Conclude()), "");
}

}  // namespace
}  // namespace sidestep::judge_copy_test
