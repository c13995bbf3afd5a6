// SPDX-License-Identifier: BSD-3-Clause
#include "controller/mpc/structured/interior_point.h"

#include "controller/mpc/structured/core_math.h"
#include "controller/mpc/structured/filter.h"

namespace sidestep::mpc::structured::SIDESTEP_ISA {
namespace {

constexpr double kAcceptable = 1e-6;   // As Ipopt's acceptable_tol.
constexpr double kColdBarrier = 0.1;   // As Ipopt's mu_init.
constexpr double kSaddleShare = 1e-3;  // Of the optimality error; tuned on random problems.
// A guess's barrier: in proportion to how far it is from optimal, within limits; tuned on
// sequences of closed-loop problems.
constexpr double kWarmShare = 4e-4;
constexpr double kLeastWarmBarrier = 1e-3;
constexpr double kLargestWarmBarrier = 3e-2;
constexpr double kPush = 1e-2;        // m/s^2 or m: a start's distance from its bounds.
constexpr double kLeastSlack = 1e-8;  // m/s^2, after a recovery.
constexpr int kMaxRecoveries = 8;
constexpr int kMaxAdaptive = 60;     // Iterations before the barrier falls monotonically.
constexpr double kLostFactor = 1e2;  // By which a step that has lost its way adds infeasibility.
// When only the cost is asked for: how well the dynamics are kept, and the share of the cost that
// the bounds' products may still take from it. A cost that, less these products, is above the
// ceiling so often in a row is taken for too dear.
constexpr double kRoughInfeasibility = 1e-3;
constexpr double kRoughShare = 1e-3;
constexpr int kDearIterations = 2;

// As in Waechter & Biegler, "On the implementation of an interior-point filter line-search
// algorithm for large-scale nonlinear programming", 2006, with their letters.
constexpr double kLeastFraction = 0.99;        // tau_min, of the way to the bounds.
constexpr double kSolvedShare = 10.0;          // kappa_epsilon: error over barrier.
constexpr double kBarrierFactor = 0.2;         // kappa_mu.
constexpr double kBarrierPower = 1.5;          // theta_mu.
constexpr double kLeastBarrierDivisor = 10.0;  // Of the tolerance.
constexpr double kMultiplierScale = 100.0;     // s_max.
constexpr double kFilterTop = 1e4;             // theta_max, of the first infeasibility.
constexpr double kSmallInfeasibility = 1e-4;   // theta_min, of the first infeasibility.
constexpr double kInfeasibilityShare = 1e-5;   // gamma_theta.
constexpr double kValueShare = 1e-8;           // gamma_phi.
constexpr double kArmijo = 1e-4;               // eta_phi.
constexpr double kSlopePower = 2.3;            // s_phi.
constexpr double kInfeasibilityPower = 1.1;    // s_theta.
constexpr double kDamping = 1e-5;              // kappa_d, of slacks without an upper bound.
constexpr double kRounding = 1e-13;            // Of a value that a step may leave as it is.
constexpr int kMaxHalvings = 25;               // Of a step, before the search is given up.
// Shift of the diagonal (delta_w): the first, the least of later ones, and how it moves. Ours
// begins higher than theirs (1e-4) and gives up after fewer attempts.
constexpr double kFirstShift = 1e-2;
constexpr double kLeastShift = 1e-8;
constexpr double kShiftDecrease = 3.0;         // 1 / kappa_w^-.
constexpr double kFirstShiftIncrease = 100.0;  // kappa_w^+ bar.
constexpr double kShiftIncrease = 8.0;         // kappa_w^+.
constexpr int kMaxShifts = 40;
// Of a patient solve: the least shift, and which steps went too far for the next to be longer.
constexpr double kLeastPatientShift = 1e-6;
constexpr double kFarFactor = 10.0;  // By which they add infeasibility.
constexpr int kMaxEasyHalvings = 2;

class Minimizer {
 public:
  Minimizer(const ProblemView& problem, const Settings& settings, Workspace* workspace)
      : problem_(problem), settings_(settings), work_(*workspace) {}

  Summary Run();

 private:
  double KktError(double barrier) const;
  bool IsRoughlySolved() const;
  bool IsTooDear();
  void LowerBarrier();
  bool FindDirection();
  bool FactorizeShifted();
  void Correct();
  bool SearchLine();
  void AdaptShift(int halvings);
  bool Recover();
  bool IsAcceptable(double step, double slope, double infeasibility, double value);
  void ResetFilter();
  void Start();
  void Accept(const StepLimits& step);
  double LeastBarrier() const { return settings_.tolerance / kLeastBarrierDivisor; }
  double Value(const Evaluation& at) const {
    return at.cost - barrier_ * (at.log_sum - Damping() * at.slack_sum);
  }
  double Damping() const { return settings_.is_patient ? kDamping : 0.0; }
  double LeastShift() const {
    return settings_.is_patient ? Max(kLeastPatientShift, last_shift_ / kShiftDecrease) : 0.0;
  }
  bool HasLostItsWay(double infeasibility_before) const {
    return settings_.is_wary &&
           work_.now.infeasibility > Max(1.0, kLostFactor * infeasibility_before);
  }

  const ProblemView& problem_;
  const Settings& settings_;
  Workspace& work_;
  Filter filter_;
  double barrier_{0.0};
  double shift_{0.0};
  double last_shift_{0.0};
  double fraction_{kLeastFraction};
  double first_infeasibility_{1.0};
  int num_recoveries_{0};
  int num_dear_{0};
  bool is_adaptive_{true};
};

double Minimizer::KktError(double barrier) const {
  const Linearization& at = work_.linear;
  int num_box = 0;
  for (int i = 0; i < 3 * problem_.num_locations; ++i)
    num_box += problem_.is_free[i] != 0.0 ? 2 : 0;
  const int num_faces = problem_.num_faces * problem_.num_slots;
  const int num_bounds = num_faces + num_box;
  const double count = 9.0 * problem_.knots + num_faces + num_bounds;
  const double dual_scale = Max(kMultiplierScale, at.multiplier_sum / count) / kMultiplierScale;
  const double product_scale =
      num_bounds == 0 ? 1.0 : Max(kMultiplierScale, at.bound_sum / num_bounds) / kMultiplierScale;
  const double product =
      num_bounds == 0 ? 0.0
                      : Max(Abs(at.largest_product - barrier), Abs(at.smallest_product - barrier));
  return Max(Max(at.dual / dual_scale, work_.now.largest_residual), product / product_scale);
}

bool Minimizer::IsRoughlySolved() const {
  return settings_.is_rough && work_.now.infeasibility <= kRoughInfeasibility &&
         work_.linear.gap_products <= kRoughShare * work_.now.cost;
}

// Of a convex problem at feasible points the cost less the products is what it can't fall below.
// Warm starts begin below the optimum, with gaps in the dynamics, and the cost rises as they close.
bool Minimizer::IsTooDear() {
  const bool is_dear = work_.now.cost - work_.linear.gap_products > settings_.ceiling;
  num_dear_ = is_dear ? num_dear_ + 1 : 0;
  return num_dear_ >= kDearIterations;
}

void Minimizer::ResetFilter() { filter_.Reset(kFilterTop * Max(1.0, first_infeasibility_)); }

void Minimizer::LowerBarrier() {
  const double least = LeastBarrier();
  while (KktError(barrier_) <= kSolvedShare * barrier_ && barrier_ > least) {
    const double next = Min(kBarrierFactor * barrier_, __builtin_pow(barrier_, kBarrierPower));
    barrier_ = Max(least, next);
    fraction_ = Max(kLeastFraction, 1.0 - barrier_);
    ResetFilter();
  }
}

// Factorises with the least shift of the diagonal that makes every pivot positive.
bool Minimizer::FactorizeShifted() {
  work_.newton.is_exact = settings_.is_exact;
  shift_ = LeastShift();
  for (int attempt = 0; attempt < kMaxShifts; ++attempt) {
    work_.newton.shift = shift_;
    if (Factorize(problem_, work_.now, work_.linear, work_.newton)) {
      if (shift_ > 0.0) last_shift_ = shift_;
      return true;
    }
    if (shift_ == 0.0) {
      shift_ = last_shift_ == 0.0 ? kFirstShift : Max(kLeastShift, last_shift_ / kShiftDecrease);
    } else {
      shift_ *= last_shift_ == 0.0 ? kFirstShiftIncrease : kShiftIncrease;
    }
  }
  return false;
}

bool Minimizer::FindDirection() {
  const double barrier = is_adaptive_ ? 0.0 : barrier_;
  SetTarget(problem_, work_.point, barrier, Damping(), work_.target);
  BuildTerms(problem_, work_.point, work_.now, work_.linear, work_.target, &work_.newton);
  if (!FactorizeShifted()) return false;
  SolveForward(problem_, work_.newton, false, work_.direction);
  CompleteDirection(problem_, work_.point, work_.now, work_.target, work_.direction);
  if (is_adaptive_) Correct();
  return true;
}

// Mehrotra's predictor and corrector: the affine step tells how far the barrier may fall. Its
// second-order term counts as far as the affine step can be taken (Colombo & Gondzio, "Further
// development of multiple centrality correctors for interior point methods", 2008): in full it
// makes the dynamics' curvature unmanageable under large pushes.
void Minimizer::Correct() {
  const StepLimits full{0.0, 0.0};
  const StepLimits affine = LimitSteps(problem_, work_.point, work_.direction, 1.0);
  const double now = AverageProduct(problem_, work_.point, work_.direction, full);
  const double then = AverageProduct(problem_, work_.point, work_.direction, affine);
  const double ratio = now > 0.0 ? then / now : 0.0;
  barrier_ = Max(LeastBarrier(), now * ratio * ratio * ratio);
  // Along directions of negative curvature the way is long: keep away from the bounds.
  if (shift_ > 0.0) barrier_ = Max(barrier_, kSaddleShare * KktError(now));
  fraction_ = Max(kLeastFraction, 1.0 - barrier_);
  ResetFilter();
  BuildCorrection(problem_, work_.point, work_.direction, barrier_, affine.primal * affine.dual,
                  work_.target, work_.change);
  ChangeSlope(problem_, work_.newton, work_.change);
  SolveForward(problem_, work_.newton, true, work_.direction);
  CompleteDirection(problem_, work_.point, work_.now, work_.target, work_.direction);
}

bool Minimizer::IsAcceptable(double step, double slope, double infeasibility, double value) {
  const double now = Value(work_.now);
  const double now_infeasibility = work_.now.infeasibility;
  if (!IsFinite(infeasibility) || !IsFinite(value)) return false;
  if (!filter_.Accepts(infeasibility, value)) return false;
  const double small = kSmallInfeasibility * Max(1.0, first_infeasibility_);
  const double slack = kRounding * Abs(now);
  const bool is_descent = slope < 0.0 && step * __builtin_pow(-slope, kSlopePower) >
                                             __builtin_pow(now_infeasibility, kInfeasibilityPower);
  if (now_infeasibility <= small && is_descent) {
    return value <= now + kArmijo * step * slope + slack;
  }
  const double least_infeasibility = (1.0 - kInfeasibilityShare) * now_infeasibility;
  const double least_value = now - kValueShare * now_infeasibility;
  const bool is_better = infeasibility <= least_infeasibility || value - slack <= least_value;
  if (is_better) filter_.Add(least_infeasibility, least_value);
  return is_better;
}

void Minimizer::Accept([[maybe_unused]] const StepLimits& step) {
  double* point = work_.point;
  work_.point = work_.trial;
  work_.trial = point;
  const Evaluation now = work_.now;
  work_.now = work_.next;
  work_.next = now;
  SafeguardMultipliers(problem_, barrier_, work_.point);
  Linearize(problem_, work_.point, &work_.linear);
}

// A patient solve's shift grows where a step led far from the linear model that it came from.
void Minimizer::AdaptShift(int halvings) {
  const double small = kSmallInfeasibility * Max(1.0, first_infeasibility_);
  const bool is_far = work_.next.infeasibility > kFarFactor * Max(work_.now.infeasibility, small);
  last_shift_ = shift_;
  if (halvings > kMaxEasyHalvings || is_far) last_shift_ *= kShiftIncrease * kShiftDecrease;
}

bool Minimizer::SearchLine() {
  StepLimits step = LimitSteps(problem_, work_.point, work_.direction, fraction_);
  const double slope = BarrierSlope(problem_, work_.point, work_.direction, work_.linear.gradient,
                                    barrier_, Damping());
  for (int halvings = 0; halvings < kMaxHalvings; ++halvings) {
    TakeStep(problem_, work_.point, work_.direction, step, work_.trial);
    Evaluate(problem_, work_.trial, &work_.next);
    if (IsAcceptable(step.primal, slope, work_.next.infeasibility, Value(work_.next))) {
      if (settings_.is_patient) AdaptShift(halvings);
      Accept(step);
      return true;
    }
    step.primal *= 0.5;
  }
  return false;
}

// When no step is accepted: first states that the dynamics follow exactly, which leaves the barrier
// function alone to judge; then also a barrier that falls only once its problem is solved.
bool Minimizer::Recover() {
  if (++num_recoveries_ > kMaxRecoveries) return false;
  if (num_recoveries_ > 1) {
    is_adaptive_ = false;
    barrier_ = Max(kColdBarrier, barrier_);
  }
  RollOut(problem_, kLeastSlack, work_.point);
  StartInside(problem_, kLeastSlack, barrier_, work_.point);
  Evaluate(problem_, work_.point, &work_.now);
  Linearize(problem_, work_.point, &work_.linear);
  first_infeasibility_ = Max(1.0, work_.now.infeasibility);
  ResetFilter();
  return IsFinite(work_.now.cost) && IsFinite(work_.linear.dual);
}

void Minimizer::Start() {
  barrier_ = settings_.is_warm ? kLeastWarmBarrier : kColdBarrier;
  StartInside(problem_, kPush, barrier_, work_.point);
  Evaluate(problem_, work_.point, &work_.now);
  Linearize(problem_, work_.point, &work_.linear);
  if (settings_.is_warm) {
    barrier_ = Max(barrier_, Min(kLargestWarmBarrier, kWarmShare * work_.linear.dual));
    StartInside(problem_, kPush, barrier_, work_.point);
    Linearize(problem_, work_.point, &work_.linear);
  }
  fraction_ = Max(kLeastFraction, 1.0 - barrier_);
}

Summary Minimizer::Run() {
  Summary summary;
  is_adaptive_ = settings_.is_adaptive && !settings_.is_patient;
  Start();
  if (settings_.is_patient) last_shift_ = kFirstShift;
  first_infeasibility_ = work_.now.infeasibility;
  for (int i = 9; i < problem_.at.s; ++i) {
    summary.first_slope = Max(summary.first_slope, Abs(work_.linear.gradient[i]));
  }
  ResetFilter();
  for (;; ++summary.iterations) {
    summary.kkt_error = KktError(0.0);
    summary.cost = work_.now.cost;
    if (summary.kkt_error <= settings_.tolerance || IsRoughlySolved()) {
      summary.outcome = Outcome::kSolved;
      return summary;
    }
    if (IsTooDear()) {
      summary.outcome = Outcome::kTooDear;
      return summary;
    }
    if (is_adaptive_ && summary.iterations == kMaxAdaptive) {
      is_adaptive_ = false;
      barrier_ = Max(barrier_, AverageProduct(problem_, work_.point, work_.direction, {0.0, 0.0}));
      ResetFilter();
    }
    if (summary.iterations == settings_.max_iterations) {
      summary.outcome = Outcome::kIterationLimit;
      return summary;
    }
    if (!is_adaptive_) LowerBarrier();
    const double infeasibility = work_.now.infeasibility;
    if (FindDirection() && SearchLine()) {
      if (HasLostItsWay(infeasibility)) break;
      continue;
    }
    if (summary.kkt_error <= kAcceptable || !Recover()) break;
  }
  summary.outcome = summary.kkt_error <= kAcceptable ? Outcome::kAcceptable : Outcome::kStuck;
  return summary;
}

}  // namespace

Summary Minimize(const ProblemView& problem, const Settings& settings, Workspace* workspace) {
  return Minimizer(problem, settings, workspace).Run();
}

}  // namespace sidestep::mpc::structured::SIDESTEP_ISA
