// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// step_qp: where and when the foot in the air should land, of a pendulum that is where it is.
//
//   minimise   w_u |u - u*|^2 + w_t (tau - tau*)^2 + w_b |b - b*|^2 + w_v |s|^2
//   over       u (foothold), b (offset), tau = e^(wT), s (beyond the viable offsets)
//   subject to u + b = u_0 + (xi - u_0) e^(-wt) tau          t: of the step, has passed
//              u in its box, T from least to longest, b in the viable offsets but for s >= 0
//
// linear in u, b, tau, so that a QP decides on the step's place and its time at once. w_t is a
// weight on T, brought to tau by dtau = w tau* dT. Source: Khadiv et al. (see pendulum.h); theirs
// is that problem every control tick. The slack s is ours: a state that nothing catches has a step
// all the same.
//
// CapturePointStep() is the same with T and b at their nominal values: the foothold from which the
// DCM that will be there goes on as ever. Source: Pratt et al., "Capture point: a step toward
// humanoid push recovery", Humanoids 2006; with an offset for walking, Englsberger et al., "Bipedal
// walking control based on capture point dynamics", IROS 2011.

#include <Eigen/Core>

#include "controller/types/dcm_params.h"
#include "controller/types/solver_status.h"
#include "controller/wbc/qp/dense_qp.h"

namespace sidestep::dcm {

/// One step of the pendulum; horizontal, in W.
struct StepProblem {
  double omega_per_s{1.0};
  double elapsed_s{0.0};                              ///< Since the support began, >= 0.
  Eigen::Vector2d stance_m{Eigen::Vector2d::Zero()};  ///< Where the pressure is until then.
  Eigen::Vector2d dcm_m{Eigen::Vector2d::Zero()};     ///< Now.
  Eigen::Vector2d nominal_step_m{Eigen::Vector2d::Zero()};
  Eigen::Vector2d least_step_m{Eigen::Vector2d::Zero()};  ///< Never above most_step_m.
  Eigen::Vector2d most_step_m{Eigen::Vector2d::Zero()};
  Eigen::Vector2d nominal_offset_m{Eigen::Vector2d::Zero()};
  Eigen::Vector2d least_offset_m{Eigen::Vector2d::Zero()};
  Eigen::Vector2d most_offset_m{Eigen::Vector2d::Zero()};
  double nominal_s{0.5};  ///< T, from the support's begin.
  double least_s{0.3};    ///< Never above longest_s.
  double longest_s{0.8};
};

/// The foothold, its offset and T.
struct StepDecision {
  QpStatus status{QpStatus::kNotSolved};  ///< Only kSolved counts.
  Eigen::Vector2d step_m{Eigen::Vector2d::Zero()};
  Eigen::Vector2d offset_m{Eigen::Vector2d::Zero()};
  double time_s{0.0};
};

/// The DCM at the step's end, T = time_s, if the pressure stays under the stance foot.
Eigen::Vector2d DcmAtTheEnd(const StepProblem& problem, double time_s);

StepDecision CapturePointStep(const StepProblem& problem);

/// The QP with its memory; copies solve on alike.
class StepQp {
 public:
  explicit StepQp(const DcmParams& params);

  /// Does not allocate.
  StepDecision Solve(const StepProblem& problem);

 private:
  void Build(const StepProblem& problem);

  DcmParams params_;
  wbc::DenseQpProblem qp_;
  wbc::DenseQpSolver solver_;
};

}  // namespace sidestep::dcm
