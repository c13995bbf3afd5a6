// SPDX-License-Identifier: BSD-3-Clause
#include "sim/verdict/judge.h"

#include <cstdio>
#include <optional>
#include <utility>

#include "sim/verdict/expectations.h"
#include "sim/verdict/run_meters.h"

namespace sidestep {
namespace {

constexpr double kAfterFall_s = 0.5;  // lets the video show that it fell

bool IsFinite(const WorldTruth& truth) {
  return truth.p_WC.allFinite() && truth.v_WC.allFinite() && truth.p_WB.allFinite() &&
         truth.q_WB.coeffs().allFinite();
}

}  // namespace

struct Judge::State {
  std::vector<Reason> FailuresIn(const std::vector<ExpectationResult>& expectations) const;

  std::vector<Expectation> expect;
  double max_slip_m;
  double mass_kg;
  double tick_s;
  RunMeters meters;
  std::vector<Reason> invalid;
};

Judge::Judge(const MeterSetup& setup, std::vector<Expectation> expect)
    : state_(new State{std::move(expect),
                       setup.bounds.max_slip_m,
                       setup.mass_kg,
                       setup.gait.tick_s,
                       RunMeters(setup),
                       {}}) {}

Judge::Judge(const Judge& other) : state_(std::make_unique<State>(*other.state_)) {}

Judge& Judge::operator=(const Judge& other) {
  state_ = std::make_unique<State>(*other.state_);
  return *this;
}

Judge::Judge(Judge&&) noexcept = default;
Judge& Judge::operator=(Judge&&) noexcept = default;
Judge::~Judge() = default;

void Judge::Add(Tick tick, const WorldTruth& truth, const ControlTick* control) {
  if (!state_->invalid.empty()) return;
  if (!IsFinite(truth)) {
    Invalidate(reason::kDiverged, "the state of the world is not finite",
               SecondsAt(tick, state_->tick_s));
    return;
  }
  state_->meters.Add(tick, truth, control);
}

std::vector<Reason> Judge::State::FailuresIn(
    const std::vector<ExpectationResult>& expectations) const {
  std::vector<Reason> reasons;
  const bool fall_fails = meters.fall().has_fallen() && !Expects(expect, "fall");
  const bool slip_fails = meters.slip_tick() && !Expects(expect, "slip");
  if (fall_fails) {
    reasons.push_back(
        {reason::kFall, meters.fall().cause(), SecondsAt(*meters.fall().fall_tick(), tick_s)});
  }
  if (slip_fails) {
    char text[96];
    std::snprintf(text, sizeof text, "a foot slid by more than %.3g m in one stance (at most %.3g)",
                  max_slip_m, meters.max_slip_m());
    reasons.push_back({reason::kSlip, text, SecondsAt(*meters.slip_tick(), tick_s)});
  }
  if (meters.solver().lost_tick()) {
    reasons.push_back({reason::kSolver,
                       "more than " + std::to_string(kMostMpcFailuresInARow) +
                           " MPC solves failed in a row; the last status is " +
                           meters.solver().lost_status(),
                       SecondsAt(*meters.solver().lost_tick(), tick_s)});
  }
  const std::optional<Solver> solver = meters.solver().failing_solver();
  if (solver && !meters.solver().lost_tick()) {
    const SolverCount& count = meters.solver().count(*solver);
    reasons.push_back({reason::kSolver,
                       std::to_string(count.failures) + " of " + std::to_string(count.solves) +
                           " " + kSolverNames[static_cast<std::size_t>(*solver)] +
                           " solves failed; at most 5 % may",
                       std::nullopt});
  }
  for (const ExpectationResult& result : expectations) {
    const std::string& metric = result.expectation.metric;
    const bool is_said = (metric == "fall" && fall_fails) || (metric == "slip" && slip_fails);
    if (result.pass || is_said) continue;
    reasons.push_back({reason::kExpectation, Describe(result), std::nullopt});
  }
  return reasons;
}

void Judge::ReplacePushes(const std::vector<Push>& pushes) { state_->meters.ReplacePushes(pushes); }

bool Judge::is_settled() const { return state_->meters.is_settled(); }

void Judge::Invalidate(const std::string& kind, const std::string& text, double time_s) {
  state_->invalid.push_back({kind, text, time_s});
}

bool Judge::finished() const {
  const State& state = *state_;
  if (!state.invalid.empty()) return true;
  const std::optional<Tick> fall_tick = state.meters.fall().fall_tick();
  return fall_tick && *state.meters.last_tick() - *fall_tick >= TickAt(kAfterFall_s, state.tick_s);
}

RunOutcome Judge::Conclude() const {
  const State& state = *state_;
  RunOutcome outcome;
  outcome.metrics = state.meters.Measure();
  outcome.footsteps = state.meters.Footsteps();
  outcome.pushes = state.meters.Pushes();
  outcome.gaits = state.meters.Gaits();
  outcome.joints = state.meters.joints().records();
  outcome.mass_kg = state.mass_kg;

  Verdict& verdict = outcome.verdict;
  verdict.expectations = CheckExpectations(state.expect, outcome.metrics);
  if (!state.invalid.empty()) {
    verdict.verdict_class = VerdictClass::kInvalid;
    verdict.reasons = state.invalid;
    return outcome;
  }
  verdict.reasons = state.FailuresIn(verdict.expectations);
  if (!verdict.reasons.empty()) verdict.verdict_class = VerdictClass::kFail;
  return outcome;
}

}  // namespace sidestep
