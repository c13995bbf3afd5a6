// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// run_meters: all that is measured of one run, tick by tick.
//
// Two groups, apart from each other to the end: what the truth shows against the scenario's nominal
// motion, and what the controller said it believed, planned and solved (BeliefMeter, SolverMeter,
// PlanLog). The first never looks at a ControlTick. A value: a copy goes on by itself.

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "controller/types/control_tick.h"
#include "controller/types/tick.h"
#include "sim/scenario/nominal_motion.h"
#include "sim/verdict/belief_meter.h"
#include "sim/verdict/fall_meter.h"
#include "sim/verdict/flight_meter.h"
#include "sim/verdict/gait_meter.h"
#include "sim/verdict/joint_meter.h"
#include "sim/verdict/meter_setup.h"
#include "sim/verdict/path_meter.h"
#include "sim/verdict/plan_log.h"
#include "sim/verdict/push_meter.h"
#include "sim/verdict/slip_meter.h"
#include "sim/verdict/sole_meter.h"
#include "sim/verdict/solver_meter.h"
#include "sim/verdict/stance_meter.h"
#include "sim/verdict/step_log.h"
#include "sim/verdict/verdict.h"
#include "sim/world/world.h"

namespace sidestep {

/// After a fall only what tells of the fall and its path goes on (height, tilt, path, impulse,
/// energy): feet, joints and the controller are no longer measured, for what a fallen robot does
/// says nothing of them.
class RunMeters {
 public:
  explicit RunMeters(const MeterSetup& setup);

  /// Takes one tick, in order, of a finite truth. @param control  Null between control ticks.
  void Add(Tick tick, const WorldTruth& truth, const ControlTick* control);

  /// Other pushes instead of those it has; see Judge.
  void ReplacePushes(const std::vector<Push>& pushes);

  /// Whether the robot stands or goes as its gait asks; see Judge.
  bool is_settled() const { return !fall_.has_fallen() && push_.is_calm(); }

  /// Every metric of sim/verdict/metrics.h.
  Metrics Measure() const;

  std::vector<FootstepRecord> Footsteps() const;  ///< See footsteps.h.
  std::vector<PushRecord> Pushes() const;         ///< In the scenario's order.

  std::vector<GaitRecord> Gaits() const { return gait_.Records(); }  ///< Likewise.

  const FallMeter& fall() const { return fall_; }
  const SolverMeter& solver() const { return solver_; }
  const JointMeter& joints() const { return joints_; }
  double max_slip_m() const;                                    ///< Of all feet (m).
  std::optional<Tick> slip_tick() const { return slip_tick_; }  ///< Beyond verdict.max_slip_m.
  std::optional<Tick> last_tick() const { return last_tick_; }

 private:
  /// Impulses and energy, from the last tick to this one.
  void Integrate(Tick tick, const WorldTruth& truth);
  void AddFeet(Tick tick, const WorldTruth& truth);
  /// Feet, flight, joints and the controller.
  void AddBeforeFall(Tick tick, const WorldTruth& truth, const ControlTick* control);
  void AddTruthMetrics(Metrics& metrics) const;
  void AddGaitMetrics(Metrics& metrics) const;
  void AddControllerMetrics(Metrics& metrics) const;
  /// Steps count for the adjustments from here on; 0 without a push.
  Tick FirstPushStart() const;

  std::vector<Push> pushes_;
  double tick_s_;
  double slip_bound_m_;
  NominalMotion nominal_;
  FallMeter fall_;
  std::vector<StanceMeter> stances_;  // one a foot, like slip_
  std::vector<SlipMeter> slip_;
  SoleMeter sole_;
  StepLog steps_;
  GaitMeter gait_;
  JointMeter joints_;
  FlightMeter flight_;
  PathMeter path_;
  PushMeter push_;
  std::vector<Eigen::Vector3d> impulse_W_Ns_;
  std::vector<Eigen::Vector3d> push_force_W_N_;  // of the last tick, acting until the next one
  double energy_J_{0.0};
  double max_angular_momentum_kgm2ps_{0.0};
  double max_self_penetration_m_{0.0};
  std::optional<Tick> slip_tick_;
  std::optional<Tick> first_tick_;
  std::optional<Tick> last_tick_;
  Tick last_standing_tick_{0};  // before any fall
  double first_x_m_{0.0};
  double last_x_m_{0.0};
  SolverMeter solver_;
  PlanLog plan_;
  BeliefMeter belief_;
};

}  // namespace sidestep
