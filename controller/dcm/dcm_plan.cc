// SPDX-License-Identifier: BSD-3-Clause
#include "controller/dcm/dcm_plan.h"

#include <algorithm>
#include <cmath>

#include "controller/planner/capture_point.h"
#include "controller/planner/gait_generator.h"
#include "controller/planner/schedule_edits.h"
#include "controller/types/gravity.h"
#include "models/support/require.h"

namespace sidestep::dcm {
namespace {

constexpr int kLandings = 5;        // e^(-wT) of what is beyond is left: nothing after five steps
constexpr double kPrepare_s = 0.6;  // before a walk begins: three pendulum time constants
constexpr double kSettle_s = 0.2;   // from the last foot to between the feet, once they stand

// The contact of `foot` that is to come; null if the plan has none.
const PlannedContact* Upcoming(const ContactPlan& plan, int foot, Tick tick) {
  for (const PlannedContact& contact : plan.feet[static_cast<std::size_t>(foot)]) {
    if (contact.start_tick > tick) return &contact;
  }
  return nullptr;
}

int NewestFoot(const GaitSupport& support) {
  return support.feet[0].nominal.sequence > support.feet[1].nominal.sequence ? 0 : 1;
}

// Whether the support began with a landing; else it has been standing.
bool BeganByLanding(const GaitSupport& support) {
  const auto newest = static_cast<std::size_t>(NewestFoot(support));
  return support.tick > 0 && support.feet[newest].nominal.contact.start_tick == support.tick;
}

// The walk whose times a step has: of one that closes up, the walk's before.
const GaitParams& WalkOf(const StepAhead& step, const GaitSupport& support) {
  const bool closes = step.gait.type != GaitType::kWalk && support.previous.has_value();
  return closes ? *support.previous : step.gait;
}

Eigen::Vector2d Middle(const std::array<Eigen::Vector2d, 2>& feet) {
  return 0.5 * (feet[0] + feet[1]);
}

}  // namespace

DcmPlan::DcmPlan(const DcmSetup& setup)
    : setup_(setup),
      omega_per_s_(1.0 / PendulumTimeConstant_s(setup.com_height_m)),
      qp_(setup.control.dcm),
      told_(1) {
  SIDESTEP_REQUIRE(setup.vertices_m.size() == 2, setup.vertices_m.size());
  Eigen::Index vertices = 0;
  for (const Eigen::Matrix3Xd& sole : setup.vertices_m) {
    force_N_.emplace_back(Eigen::Matrix3Xd::Zero(3, sole.cols()));
    vertices += sole.cols();
  }
  SIDESTEP_REQUIRE(vertices <= static_cast<Eigen::Index>(SupportArea::kMost), vertices);
}

void DcmPlan::Update(const RobotState& state, const Eigen::Vector3d& momentum, Tick tick,
                     GaitPlanner* planner) {
  now_ = tick;
  dcm_m_ = (state.p_WC + state.v_WC / omega_per_s_).head<2>();
  LayOutPath(state, *planner);
  DecideOnStep(state, planner);
  LayOutPath(state, *planner);
  Bear(state, planner->plan(), momentum, planner->ReferenceAt(tick).p_WC.z());
}

// From the support that is on, landing by landing. Later footholds keep their nominal distance from
// the next one, wherever that has been put.
void DcmPlan::LayOutPath(const RobotState& state, const GaitPlanner& planner) {
  path_.Clear();
  Feet feet{state.feet[0].p_WF.head<2>(), state.feet[1].p_WF.head<2>()};
  Eigen::Vector2d off_m = Eigen::Vector2d::Zero();
  std::optional<GaitSupport> support = planner.support();
  for (int landings = 0; landings < kLandings;) {
    const auto next = NextSupport(planner.setup(), *support);
    const auto step = StepAheadOf(planner.setup(), *support);
    if (!next || !step) {
      AddRest(*support, feet, next ? std::optional<Tick>(next->tick) : std::nullopt);
      end_m_ = Middle(feet);
      if (!next) return;
      ++landings;
    } else {
      AddStep(*support, *step, feet);
      const auto foot = static_cast<std::size_t>(step->foot);
      const Eigen::Vector2d nominal_m = next->feet[foot].nominal.contact.nominal_p_WF.head<2>();
      const PlannedContact* contact = Upcoming(planner.plan(), step->foot, now_);
      if (landings++ == 0 && contact != nullptr) {
        off_m = contact->adjusted_p_WF.head<2>() - nominal_m;
      }
      feet[foot] = nominal_m + off_m;
      end_m_ = Middle(feet);
    }
    support = next;
  }
  path_.Add(path_.end_s() + kSettle_s, Middle(feet));
}

void DcmPlan::AddRest(const GaitSupport& support, const Feet& feet, std::optional<Tick> until) {
  double begin_s = After(support.tick);
  if (BeganByLanding(support)) {
    path_.Add(begin_s, feet[static_cast<std::size_t>(1 - NewestFoot(support))]);
    begin_s += kSettle_s;
  }
  path_.Add(begin_s, Middle(feet));
  if (until) path_.Add(std::max(begin_s, After(*until) - kPrepare_s), Middle(feet));
}

void DcmPlan::AddStep(const GaitSupport& support, const StepAhead& step, const Feet& feet) {
  const Eigen::Vector2d& stance_m = feet[static_cast<std::size_t>(1 - step.foot)];
  if (BeganByLanding(support)) {
    path_.Add(After(support.tick), feet[static_cast<std::size_t>(1 - NewestFoot(support))]);
  }
  path_.Add(After(step.lift_off), stance_m);
  path_.Add(After(step.landing), stance_m);
}

void DcmPlan::DecideOnStep(const RobotState& state, GaitPlanner* planner) {
  qp_status_ = QpStatus::kNotSolved;
  const auto step = StepAheadOf(planner->setup(), planner->support());
  if (!step || now_ >= step->landing) return;
  const PlannedContact* contact = Upcoming(planner->plan(), step->foot, now_);
  if (contact == nullptr) return;
  const GaitSupport& support = planner->support();
  const double delay_s = SwitchDelay_s(WalkOf(*step, support).double_support_s, omega_per_s_);
  StepProblem problem = Pose(support, *step, *contact, delay_s);
  problem.stance_m = HeldPressure(state, static_cast<std::size_t>(1 - step->foot), problem);
  const bool has_begun =
      BeganByLanding(support) ? problem.elapsed_s >= 0.0 : now_ >= step->lift_off;
  if (!has_begun) return;
  const bool is_qp = setup_.control.stepping == Stepping::kDcmQp;
  const StepDecision decision = is_qp ? qp_.Solve(problem) : CapturePointStep(problem);
  if (is_qp) qp_status_ = decision.status;
  if (decision.status != QpStatus::kSolved) return;
  decision_ = decision;
  const double ahead_s = decision.time_s - problem.elapsed_s - delay_s;
  Tell(*step, *contact, is_qp ? now_ + TickAt(ahead_s, setup_.tick_s) : step->landing, planner);
}

// T is counted from where the support might have jumped to the standing foot to where it might jump
// to the next one: both SwitchDelay_s after a landing.
StepProblem DcmPlan::Pose(const GaitSupport& support, const StepAhead& step,
                          const PlannedContact& contact, double delay_s) const {
  const GaitParams& gait = WalkOf(step, support);
  const TimingParams& timing = setup_.control.planner.timing;
  const double both_s = SecondsAt(step.lift_off - support.tick, setup_.tick_s);
  const double begin_s = After(support.tick) + SwitchDelay_s(both_s, omega_per_s_);
  const double lift_off_s = After(step.lift_off), landing_s = After(step.landing);
  const double quickest_s = std::min(timing.least_swing_s, gait.swing_s);
  const bool is_free =
      setup_.control.stepping == Stepping::kDcmQp && landing_s > timing.least_rest_s;
  StepProblem problem;
  problem.omega_per_s = omega_per_s_;
  problem.elapsed_s = -begin_s;
  problem.dcm_m = dcm_m_;
  problem.nominal_step_m = contact.nominal_p_WF.head<2>();
  problem.least_step_m = problem.nominal_step_m + contact.box_lower_m.head<2>();
  problem.most_step_m = problem.nominal_step_m + contact.box_upper_m.head<2>();
  const auto time_to = [&](double landed_s) { return landed_s + delay_s - begin_s; };
  problem.least_s = problem.longest_s = problem.nominal_s = time_to(landing_s);
  if (is_free) {
    problem.nominal_s = time_to(lift_off_s + gait.swing_s);
    problem.least_s = time_to(std::max(timing.least_rest_s, lift_off_s + quickest_s));
    problem.longest_s =
        std::max(problem.least_s, time_to(lift_off_s + setup_.control.dcm.longest_swing_s));
  }
  const double rest_s = gait.double_support_s - delay_s;
  problem.nominal_offset_m = std::exp(-omega_per_s_ * rest_s) *
                             (path_.DcmAt(landing_s + gait.double_support_s, end_m_, omega_per_s_) -
                              contact.adjusted_p_WF.head<2>());
  BoundOffset(step, gait, &problem);
  return problem;
}

// By the widest, narrowest, farthest and quickest steps that the gait's boxes allow.
void DcmPlan::BoundOffset(const StepAhead& step, const GaitParams& gait,
                          StepProblem* problem) const {
  const ControlParams& control = setup_.control;
  const Eigen::Vector3d &lower_m = control.mpc.box_lower_m, &upper_m = control.mpc.box_upper_m;
  const double quickest_s =
      std::min(control.planner.timing.least_swing_s, gait.swing_s) + gait.double_support_s;
  const double growth = std::exp(omega_per_s_ * quickest_s);
  const Interval forward =
      ViableForward({gait.step_length_m + lower_m.x(), gait.step_length_m + upper_m.x()}, growth);
  const Interval inward =
      ViableSideways({std::max(gait.step_width_m + lower_m.y(), control.planner.min_step_width_m),
                      gait.step_width_m + upper_m.y()},
                     growth);
  const bool is_left = step.foot == 0;
  problem->least_offset_m = {forward.least, is_left ? -inward.most : inward.least};
  problem->most_offset_m = {forward.most, is_left ? -inward.least : inward.most};
}

void DcmPlan::Tell(const StepAhead& step, const PlannedContact& contact, Tick landing,
                   GaitPlanner* planner) {
  told_[0] = {step.foot, contact.index, contact.nominal_p_WF};
  told_[0].p_WF.head<2>() = decision_.step_m;
  if (landing != step.landing) {
    const TouchDownMove move{planner->support().sequence + 1, landing - step.landing};
    const auto moved = MoveTouchDown(planner->setup(), planner->support(), now_, move, 1);
    if (moved) planner->Adopt(*moved);
  }
  planner->AdoptFootholds(told_);
}

void DcmPlan::AddSole(const RobotState& state, std::size_t foot, SupportArea* area) const {
  const FootState& at = state.feet[foot];
  const Eigen::Matrix3Xd& vertices_m = setup_.vertices_m[foot];
  const Eigen::Vector3d middle_m = vertices_m.rowwise().mean();
  for (const auto& vertex_m : vertices_m.colwise()) {
    const Eigen::Vector3d inner_m =
        middle_m + setup_.control.dcm.sole_share * (vertex_m - middle_m);
    area->Add((at.p_WF + at.R_WF * inner_m).head<2>(), 0.0);
  }
}

// The pressure that, held until the support's end, would let the nominal step do; as near to it as
// the sole reaches.
Eigen::Vector2d DcmPlan::HeldPressure(const RobotState& state, std::size_t stance,
                                      const StepProblem& problem) const {
  SupportArea sole;
  AddSole(state, stance, &sole);
  const double ahead_s = std::max(problem.nominal_s - problem.elapsed_s, setup_.tick_s);
  const double growth = std::exp(omega_per_s_ * ahead_s);
  const Eigen::Vector2d end_m = problem.nominal_step_m + problem.nominal_offset_m;
  return sole.Nearest((growth * problem.dcm_m - end_m) / (growth - 1.0));
}

void DcmPlan::Bear(const RobotState& state, const ContactPlan& plan,
                   const Eigen::Vector3d& momentum, double height_m) {
  SupportArea area;
  for (std::size_t foot = 0; foot < 2; ++foot) {
    stands_[foot] = plan.feet[foot].front().start_tick <= now_;
    if (!stands_[foot]) continue;
    AddSole(state, foot, &area);
  }
  const Eigen::Vector2d error_m = dcm_m_ - path_.DcmAt(0.0, end_m_, omega_per_s_);
  Eigen::Vector2d pressure_m =
      path_.At(0.0) + (1.0 + setup_.control.dcm.gain_per_s / omega_per_s_) * error_m;
  if (!area.is_empty()) pressure_m = area.Nearest(pressure_m);
  const Eigen::Vector2d borne_mps2 =
      omega_per_s_ * omega_per_s_ * (state.p_WC.head<2>() - pressure_m);
  com_.p_WC << state.p_WC.head<2>(), height_m;
  com_.v_WC << state.v_WC.head<2>(), 0.0;
  com_.a_WC << borne_mps2 + state.external_wrench.force_N.head<2>() / setup_.mass_kg, 0.0;
  com_.angular_momentum = momentum;
  ShareOut(state, pressure_m);
}

// Between the feet by where the pressure is on the way from one to the other.
void DcmPlan::ShareOut(const RobotState& state, const Eigen::Vector2d& pressure_m) {
  const Feet feet{state.feet[0].p_WF.head<2>(), state.feet[1].p_WF.head<2>()};
  const Eigen::Vector2d across_m = feet[1] - feet[0];
  double on_right = stands_[1] ? 1.0 : 0.0;
  if (stands_[0] && stands_[1]) {
    constexpr double kTogether_m2 = 1e-6;  // feet in one place share alike
    const double way = across_m.dot(pressure_m - feet[0]) / across_m.squaredNorm();
    on_right = across_m.squaredNorm() > kTogether_m2 ? std::clamp(way, 0.0, 1.0) : 0.5;
  }
  SupportArea soles;
  for (std::size_t foot = 0; foot < 2; ++foot) {
    if (!stands_[foot]) continue;
    const double liked = (foot == 0 ? 1.0 - on_right : on_right) /
                         static_cast<double>(setup_.vertices_m[foot].cols());
    for (const auto& vertex_m : setup_.vertices_m[foot].colwise()) {
      soles.Add((state.feet[foot].p_WF + state.feet[foot].R_WF * vertex_m).head<2>(), liked);
    }
  }
  if (!soles.is_empty()) soles.ShareOut(pressure_m);
  const Eigen::Vector3d force_N =
      setup_.mass_kg * (com_.a_WC + Eigen::Vector3d(0.0, 0.0, kGravity_mps2)) -
      state.external_wrench.force_N;
  std::size_t vertex = 0;
  for (std::size_t foot = 0; foot < 2; ++foot) {
    force_N_[foot].setZero();
    if (!stands_[foot]) continue;
    for (auto on_vertex_N : force_N_[foot].colwise()) on_vertex_N = soles.share(vertex++) * force_N;
  }
}

}  // namespace sidestep::dcm
