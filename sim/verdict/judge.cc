// SPDX-License-Identifier: BSD-3-Clause
#include "sim/verdict/judge.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numeric>
#include <optional>
#include <vector>

#include "controller/types/gravity.h"
#include "models/support/require.h"
#include "sim/verdict/expectations.h"
#include "sim/verdict/fall_meter.h"
#include "sim/verdict/flight_meter.h"
#include "sim/verdict/footstep_log.h"
#include "sim/verdict/joint_meter.h"
#include "sim/verdict/path_meter.h"
#include "sim/verdict/slip_meter.h"
#include "sim/verdict/sole_meter.h"
#include "sim/verdict/solver_meter.h"

namespace sidestep {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kLoadedShare = 0.05;  // of the weight: a foot with less on it does not stand.
constexpr double kAfterFall_s = 0.5;   // lets the video show that it fell

double MeanOrNaN(const std::vector<double>& values) {
  if (values.empty()) return kNaN;
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double LargestOrZero(const std::vector<double>& values) {
  return values.empty() ? 0.0 : *std::max_element(values.begin(), values.end());
}

bool IsFinite(const WorldTruth& truth) {
  return truth.p_WC.allFinite() && truth.v_WC.allFinite() && truth.p_WB.allFinite() &&
         truth.q_WB.coeffs().allFinite();
}

}  // namespace

struct Judge::State {
  State(const Scenario& scenario_of_run, double mass_kg_of_plant,
        const std::vector<JointInfo>& joints_of_plant)
      : scenario(scenario_of_run),
        mass_kg(mass_kg_of_plant),
        tick_s(scenario.world.step_s),
        fall(scenario),
        slip(scenario.description_of_robot.feet.size(),
             SlipMeter(tick_s, kLoadedShare * mass_kg * kGravity_mps2)),
        sole(scenario.description_of_robot.feet, kLoadedShare * mass_kg * kGravity_mps2),
        joints(joints_of_plant, tick_s),
        footsteps(scenario.description_of_robot.feet),
        path(scenario),
        flight(tick_s),
        solver(scenario.control.mpc.friction),
        planned_contact(slip.size(), true),
        impulse_W_Ns(scenario.pushes.size(), Eigen::Vector3d::Zero()) {}

  void AddBeforeFall(Tick tick, const WorldTruth& truth, const ControlTick* control);
  void Integrate(Tick tick, const WorldTruth& truth);
  std::optional<Tick> FirstPushStart() const;
  std::optional<Tick> LastPushEnd() const;
  double MaxSlip_m() const;
  Metrics Measure() const;
  std::vector<Reason> FailuresIn(const std::vector<ExpectationResult>& expectations) const;

  Scenario scenario;
  double mass_kg;
  double tick_s;
  FallMeter fall;
  std::vector<SlipMeter> slip;
  SoleMeter sole;
  JointMeter joints;
  FootstepLog footsteps;
  PathMeter path;
  FlightMeter flight;
  SolverMeter solver;
  std::vector<bool> planned_contact;  // of the last control tick; all feet without a plan
  std::vector<Eigen::Vector3d> impulse_W_Ns;
  std::vector<Eigen::Vector3d> push_force_W_N;  // of the last tick, acting until the next one
  double energy_J{0.0};
  double max_angular_momentum_kgm2ps{0.0};
  double max_self_penetration_m{0.0};
  std::optional<Tick> slip_tick;
  std::optional<Tick> first_tick;
  Tick last_tick{0};
  double first_x_m{0.0};
  double last_x_m{0.0};
  std::vector<Reason> invalid;
};

Judge::Judge(const Scenario& scenario, double mass_kg, const std::vector<JointInfo>& joints)
    : state_(std::make_unique<State>(scenario, mass_kg, joints)) {
  SIDESTEP_REQUIRE(mass_kg > 0.0, mass_kg);
}

Judge::Judge(const Judge& other) : state_(std::make_unique<State>(*other.state_)) {}
Judge::Judge(Judge&&) noexcept = default;
Judge::~Judge() = default;

void Judge::Add(Tick tick, const WorldTruth& truth, const ControlTick* control) {
  State& state = *state_;
  if (!state.invalid.empty()) return;
  if (!IsFinite(truth)) {
    Invalidate(reason::kDiverged, "the state of the world is not finite",
               SecondsAt(tick, state.tick_s));
    return;
  }
  SIDESTEP_REQUIRE(!state.first_tick || tick > state.last_tick, tick);
  state.Integrate(tick, truth);
  state.fall.Add(tick, truth);
  if (!state.fall.has_fallen()) state.AddBeforeFall(tick, truth, control);
  if (control) state.path.Add(tick, truth, control->reference);
}

void Judge::State::AddBeforeFall(Tick tick, const WorldTruth& truth, const ControlTick* control) {
  SIDESTEP_REQUIRE(truth.feet.size() == slip.size(), truth.feet.size());
  if (control) {
    solver.Add(tick, *control);
    footsteps.AddPlan(tick, *control);
    for (std::size_t i = 0; i < control->feet.size(); ++i) {
      planned_contact[i] = control->feet[i].planned_contact;
    }
  }
  std::vector<double> stance_slip_m;
  for (std::size_t i = 0; i < slip.size(); ++i) {
    slip[i].Add(tick, truth.feet[i], planned_contact[i]);
    stance_slip_m.push_back(slip[i].stance_slip_m());
  }
  footsteps.AddTruth(truth, stance_slip_m);
  flight.Add(truth, control);
  sole.Add(truth, planned_contact);
  joints.Add(truth);
  max_self_penetration_m = std::max(max_self_penetration_m, truth.self_contact_depth_m);
  if (!slip_tick && MaxSlip_m() > scenario.verdict.max_slip_m) slip_tick = tick;
}

// Adds up what acted from the last tick to this one.
void Judge::State::Integrate(Tick tick, const WorldTruth& truth) {
  if (!first_tick) {
    first_tick = tick;
    first_x_m = truth.p_WC.x();
  } else {
    const double dt_s = SecondsAt(tick - last_tick, tick_s);
    for (std::size_t i = 0; i < push_force_W_N.size(); ++i) {
      impulse_W_Ns[i] += push_force_W_N[i] * dt_s;
    }
    energy_J += truth.actuator_power_W * dt_s;
  }
  SIDESTEP_REQUIRE(truth.pushes.size() == impulse_W_Ns.size(), truth.pushes.size());
  push_force_W_N.clear();
  for (const PushTruth& push : truth.pushes) push_force_W_N.push_back(push.force_W_N);
  last_tick = tick;
  last_x_m = truth.p_WC.x();
  max_angular_momentum_kgm2ps =
      std::max(max_angular_momentum_kgm2ps, truth.angular_momentum.norm());
}

std::optional<Tick> Judge::State::FirstPushStart() const {
  std::optional<Tick> first;
  for (const Push& push : scenario.pushes) {
    const Tick start = TickAt(push.start_s, tick_s);
    first = std::min(first.value_or(start), start);
  }
  return first;
}

std::optional<Tick> Judge::State::LastPushEnd() const {
  std::optional<Tick> last;
  for (const Push& push : scenario.pushes) {
    const Tick end = TickAt(push.start_s + push.duration_s, tick_s);
    last = std::max(last.value_or(end), end);
  }
  return last;
}

double Judge::State::MaxSlip_m() const {
  double max_slip_m = 0.0;
  for (const SlipMeter& meter : slip) max_slip_m = std::max(max_slip_m, meter.max_slip_m());
  return max_slip_m;
}

Metrics Judge::State::Measure() const {
  const bool has_fallen = fall.has_fallen();
  PathFigures figures = path.Conclude(LastPushEnd());
  if (has_fallen && LastPushEnd()) {
    figures.recovery_time_s = std::numeric_limits<double>::infinity();
  }
  const double duration_s = first_tick ? SecondsAt(last_tick - *first_tick, tick_s) : 0.0;
  const std::vector<double> adjustments_m = footsteps.AdjustmentsFrom(FirstPushStart().value_or(0));
  return {
      {"fall", has_fallen},
      {"slip", slip_tick.has_value()},
      {"fall_time_s", has_fallen ? SecondsAt(*fall.fall_tick(), tick_s) : kNaN},
      {"min_base_height_m", first_tick ? fall.min_height_m() : kNaN},
      {"max_base_height_m", first_tick ? fall.max_height_m() : kNaN},
      {"max_tilt_rad", fall.max_tilt_rad()},
      {"max_angular_momentum_kgm2ps", max_angular_momentum_kgm2ps},
      {"max_slip_m", MaxSlip_m()},
      {"final_path_error_m", figures.final_path_error_m},
      {"final_speed_error_mps", figures.final_speed_error_mps},
      {"recovery_time_s", figures.recovery_time_s},
      {"max_path_error_m", figures.max_path_error_m},
      {"mean_step_adjustment_m", MeanOrNaN(adjustments_m)},
      {"max_step_adjustment_m", LargestOrZero(adjustments_m)},
      {"mean_forward_speed_mps", duration_s > 0.0 ? (last_x_m - first_x_m) / duration_s : kNaN},
      {"apex_height_error_m", flight.max_apex_error_m()},
      {"mpc_failures", static_cast<double>(solver.mpc_failures())},
      {"wbc_failures", static_cast<double>(solver.wbc_failures())},
      {"solver_fallbacks", static_cast<double>(solver.fallbacks())},
      {"max_cone_violation_N", solver.max_cone_violation_N()},
      {"max_box_violation_m", footsteps.max_box_violation_m()},
      {"min_swing_clearance_m", footsteps.min_swing_clearance_m()},
      {"max_sole_tilt_rad", sole.max_tilt_rad()},
      {"max_self_penetration_m", max_self_penetration_m},
      {"min_joint_margin_rad", joints.min_margin_rad()},
      {"max_torque_ratio", joints.max_torque_ratio()},
      {"torque_saturation_s", joints.saturation_s()},
      {"energy_J", energy_J},
  };
}

std::vector<Reason> Judge::State::FailuresIn(
    const std::vector<ExpectationResult>& expectations) const {
  std::vector<Reason> reasons;
  const bool fall_fails = fall.has_fallen() && !Expects(scenario.expect, "fall");
  const bool slip_fails = slip_tick && !Expects(scenario.expect, "slip");
  if (fall_fails) {
    reasons.push_back({reason::kFall, fall.cause(), SecondsAt(*fall.fall_tick(), tick_s)});
  }
  if (slip_fails) {
    char text[96];
    std::snprintf(text, sizeof text, "a foot slid by more than %.3g m in one stance (at most %.3g)",
                  scenario.verdict.max_slip_m, MaxSlip_m());
    reasons.push_back({reason::kSlip, text, SecondsAt(*slip_tick, tick_s)});
  }
  if (solver.lost_tick()) {
    reasons.push_back({reason::kSolver,
                       "more than " + std::to_string(kMostMpcFailuresInARow) +
                           " MPC solves failed in a row; the last status is " +
                           solver.lost_status(),
                       SecondsAt(*solver.lost_tick(), tick_s)});
  }
  for (const ExpectationResult& result : expectations) {
    const std::string& metric = result.expectation.metric;
    const bool is_said = (metric == "fall" && fall_fails) || (metric == "slip" && slip_fails);
    if (result.pass || is_said) continue;
    reasons.push_back({reason::kExpectation, Describe(result), std::nullopt});
  }
  return reasons;
}

void Judge::Invalidate(const std::string& kind, const std::string& text, double time_s) {
  state_->invalid.push_back({kind, text, time_s});
}

bool Judge::has_fallen() const { return state_->fall.has_fallen(); }

bool Judge::finished() const {
  const State& state = *state_;
  if (!state.invalid.empty()) return true;
  const std::optional<Tick> fall_tick = state.fall.fall_tick();
  return fall_tick && state.last_tick - *fall_tick >= TickAt(kAfterFall_s, state.tick_s);
}

RunOutcome Judge::Conclude() const {
  const State& state = *state_;
  RunOutcome outcome;
  outcome.metrics = state.Measure();
  outcome.footsteps = state.footsteps.footsteps();
  for (std::size_t i = 0; i < state.scenario.pushes.size(); ++i) {
    outcome.pushes.push_back({state.scenario.pushes[i], state.impulse_W_Ns[i]});
  }
  outcome.joints = state.joints.records();
  outcome.mass_kg = state.mass_kg;

  Verdict& verdict = outcome.verdict;
  verdict.expectations = CheckExpectations(state.scenario.expect, outcome.metrics);
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
