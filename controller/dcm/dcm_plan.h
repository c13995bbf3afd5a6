// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// dcm_plan: what stands in the MPC's place with control.stepping dcm_qp and capture_point.
//
//   state, schedule -> place (and time) of the next step -> DCM reference -> pressure -> CoM,
//   forces
//
// The VRP is meant to be under the standing foot and to go straight over to the next one in each
// double support; from the footholds to come the DCM's reference follows backwards. What the DCM
// is off it, the pressure takes back at gain_per_s as far as the soles reach, and the next step
// takes the rest (step_qp.h), counting on what the pressure could do if held until then. The CoM
// needs no reference: it follows the DCM. Sources: see pendulum.h and step_qp.h; here nominal
// footholds are the planner's, which follow the robot as PlannerParams::follow says, and a step
// that is moved in time is an edit of the schedule.
//
// A value: copies go on alike. Two feet on level ground.

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

#include "controller/dcm/pendulum.h"
#include "controller/dcm/step_qp.h"
#include "controller/dcm/support_area.h"
#include "controller/planner/gait_planner.h"
#include "controller/planner/step_ahead.h"
#include "controller/types/control_params.h"
#include "controller/types/control_tick.h"

namespace sidestep::dcm {

/// The robot as a pendulum on two soles, and how it is to step.
struct DcmSetup {
  ControlParams control;     ///< stepping, dcm, planner.timing, the boxes and the least width.
  double com_height_m{0.5};  ///< Above the ground.
  double mass_kg{1.0};
  std::vector<Eigen::Matrix3Xd> vertices_m;  ///< Of each sole, in F.
  double tick_s{0.001};
};

class DcmPlan {
 public:
  /// Throws ContractViolation unless there are two feet, of few vertices.
  explicit DcmPlan(const DcmSetup& setup);

  /// Decides on the next step of the schedule that `planner` has at `tick`, and tells it; then how
  /// to bear on the ground now. Call every control tick, after GaitPlanner::Update(). `momentum`
  /// (kg m^2/s, about C, in W) is passed on to be followed. Does not allocate.
  void Update(const RobotState& state, const Eigen::Vector3d& momentum, Tick tick,
              GaitPlanner* planner);

  /// CoM as of the last Update(): the belief's own place and speed, for the DCM is what is tracked,
  /// at the gait's height, with the acceleration that the pressure gives it.
  const ComTarget& com() const { return com_; }

  /// Forces on the vertices of `foot` as of the last Update() (3 x n_v, N, in W); zero where it
  /// does not stand.
  const Eigen::Matrix3Xd& ForceOn(std::size_t foot) const { return force_N_[foot]; }

  /// Of the last decision; status kNotSolved if there has been none.
  const StepDecision& decision() const { return decision_; }

  /// How the last Update()'s QP went; kNotSolved if it had none to solve.
  QpStatus qp_status() const { return qp_status_; }

 private:
  using Feet = std::array<Eigen::Vector2d, 2>;

  double After(Tick tick) const { return SecondsAt(tick - now_, setup_.tick_s); }
  void LayOutPath(const RobotState& state, const GaitPlanner& planner);
  void AddRest(const GaitSupport& support, const Feet& feet, std::optional<Tick> until);
  void AddStep(const GaitSupport& support, const StepAhead& step, const Feet& feet);
  void DecideOnStep(const RobotState& state, GaitPlanner* planner);
  StepProblem Pose(const GaitSupport& support, const StepAhead& step, const PlannedContact& contact,
                   double delay_s) const;
  void AddSole(const RobotState& state, std::size_t foot, SupportArea* area) const;
  Eigen::Vector2d HeldPressure(const RobotState& state, std::size_t stance,
                               const StepProblem& problem) const;
  void BoundOffset(const StepAhead& step, const GaitParams& gait, StepProblem* problem) const;
  void Tell(const StepAhead& step, const PlannedContact& contact, Tick landing,
            GaitPlanner* planner);
  void Bear(const RobotState& state, const ContactPlan& plan, const Eigen::Vector3d& momentum,
            double height_m);
  void ShareOut(const RobotState& state, const Eigen::Vector2d& pressure_m);

  DcmSetup setup_;
  double omega_per_s_;
  StepQp qp_;
  Tick now_{0};
  Eigen::Vector2d dcm_m_{Eigen::Vector2d::Zero()};  // the belief's
  VrpPath path_;                                    // times from now_ on
  Eigen::Vector2d end_m_{Eigen::Vector2d::Zero()};  // of the DCM, where the path ends
  StepDecision decision_;
  QpStatus qp_status_{QpStatus::kNotSolved};
  std::vector<Foothold> told_;
  std::array<bool, 2> stands_{};
  ComTarget com_;
  std::vector<Eigen::Matrix3Xd> force_N_;
};

}  // namespace sidestep::dcm
