// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// centroidal_mpc: the MPC as a stage of the control chain: builds, warm-starts, solves, keeps the
// plan in use, and falls back to the previous plan when a solve fails.

#include <cstddef>
#include <deque>
#include <vector>

#include "controller/mpc/problem/centroidal_solver.h"
#include "controller/mpc/problem/solver_setup.h"
#include "controller/mpc/problem_builder.h"
#include "controller/types/control_tick.h"
#include "models/support/clone_ptr.h"

namespace sidestep::mpc {

class CentroidalMpc {
 public:
  CentroidalMpc(const MpcParams& params, const RobotModel& robot, double tick_s);

  /// The knots of a solve at `tick` for `plan`: where its references belong.
  KnotGrid GridAt(const ContactPlan& plan, Tick tick) const { return builder_.GridAt(plan, tick); }

  /// Solves at `tick` from the belief. A failed solve leaves the plan in use as it is: read later
  /// in its own time, that is the shifted previous solution.
  void Solve(const RobotState& state, const ContactPlan& plan, const GridReferences& references,
             Tick tick);

  /// The cost of what Solve() would find, as CentroidalSolver::Weigh() has it. Changes no plan.
  double CostOf(const RobotState& state, const ContactPlan& plan, const GridReferences& references,
                Tick tick, double ceiling);

  /// Makes a solution the plan in use once it is latency_s old, however many were made meanwhile.
  /// Call every tick; returns true when the plan changed, and footholds() with it.
  bool Activate(Tick tick);

  /// True once there is a plan to read.
  bool has_plan() const { return active_ != kNone; }

  /// Footholds that the plan in use decided: landings ahead of it when it was made.
  const std::vector<Foothold>& footholds() const { return Active().footholds; }

  /// CoM motion and angular momentum that the plan implies at `tick`: acceleration and the
  /// momentum's rate are constant within a knot.
  ComTarget ComAt(Tick tick) const;

  /// Forces of the plan's knot at `tick` on the vertices of `foot` (3 x n_v, N, in W).
  const Eigen::Matrix3Xd& ForceAt(std::size_t foot, Tick tick) const;

  /// Seconds since the measurement behind the plan in use.
  double Age_s(Tick tick) const;

  /// How the last solve went; `ran` is false before the first.
  const MpcReport& report() const { return report_; }

  /// The last problem, for dumps.
  const CentroidalOcp& problem() const { return builder_.ocp(); }

  /// How Solve() went about the last problem, for dumps.
  SolverSetup solver_setup() const;

 private:
  /// A solution with the problem and the instant it belongs to.
  struct Plan {
    KnotGrid grid;  ///< Knot 0 is the measurement's instant.
    CentroidalOcp ocp;
    MpcSolution solution;  ///< Usable: others are not kept.
    std::vector<Foothold> footholds;
  };

  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  /// Poses the problem in the builder. @return  Where to begin, as WarmStart().
  const MpcSolution* Pose(const RobotState& state, const ContactPlan& plan,
                          const GridReferences& references, Tick tick);
  /// Input of `plan` that is on at `tick`, the last one once the plan has run out.
  static int InputAt(const Plan& plan, Tick tick);
  /// The newest usable solution shifted by whole knots to those of the last problem, `ocp`; null if
  /// nothing of it is left.
  const MpcSolution* WarmStart(const CentroidalOcp& ocp);
  /// Lets the horizon begin between the velocity that the plan in use has now and the believed one,
  /// the nearer to the latter the older the plan: MpcParams::plan_memory_s.
  void RememberVelocity(CentroidalOcp* ocp, Tick tick) const;
  /// The plan's forces just before `tick`, for feet that stood then and stand now: the rate into
  /// the first knot is charged too.
  void SetPreviousForces(CentroidalOcp* ocp, Tick tick) const;
  void StorePlan(const CentroidalOcp& ocp, const MpcSolution& solution);
  /// A plan that is neither in use, waiting nor the next warm start; makes one if there is none.
  std::size_t FreeSlot();
  const Plan& Active() const { return plans_[active_]; }

  double tick_s_;
  Tick latency_ticks_;
  double plan_memory_s_;
  MpcBackend backend_;
  SolverOptions options_;
  ProblemBuilder builder_;
  ClonePtr<CentroidalSolver> solver_;
  std::deque<Plan> plans_;            // as many as are in use or waiting at once; never move
  std::vector<std::size_t> waiting_;  // of plans_: younger than the latency, oldest first
  std::size_t newest_{kNone};         // of plans_: last usable solution, the next warm start
  std::size_t active_{kNone};         // of plans_: in use
  MpcSolution guess_;
  bool began_cold_{true};  // the last Solve()
  MpcReport report_;
};

}  // namespace sidestep::mpc
