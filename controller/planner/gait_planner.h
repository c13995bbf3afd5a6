// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// gait_planner: the contacts and the CoM reference that the MPC sees at one instant.
//
// Keeps where the gait is (GaitSupport), takes it on at each touch-down, and generates the schedule
// of a horizon from it anew every tick. What has been found out of a contact stays attached to it:
// where the MPC decided to step, where its foot was felt, how far its path was shifted.
//
// With FollowMode::kCapturePoint it shifts what is still to come so that a robot that was pushed
// off its path steps on from where it is going, and drifts back to the path at no more than
// path_return_m a step. At each landing the shift becomes the capture point's distance from where
// the nominal motion would have it (capture_point.h). With FollowMode::kPath nothing shifts.
//
// A value: copies are independent and go on alike.

#include <Eigen/Core>
#include <array>
#include <vector>

#include "controller/planner/contact_schedule.h"
#include "controller/planner/gait_setup.h"
#include "controller/planner/gait_support.h"
#include "controller/planner/swing_reach.h"
#include "controller/planner/touch_down_events.h"
#include "controller/types/contact_plan.h"
#include "controller/types/gait_params.h"
#include "controller/types/robot_state.h"

namespace sidestep {

class GaitPlanner {
 public:
  /// Begins standing at tick 0, plan() and all. `horizon` (ticks) is how far contacts are planned
  /// ahead, `touch_downs` what makes a landing. Throws ContractViolation without segments.
  GaitPlanner(const GaitSetup& setup, const PlannerParams& params, Tick horizon,
              const TouchDownRule& touch_downs = {});

  /// Contacts that end after `tick` and begin no later than tick + horizon, for every foot; at
  /// least one a foot. Call with increasing ticks. A contact that has begun is reported where the
  /// belief sees its foot. Takes no memory (a copy of a planner: only once).
  const ContactPlan& Update(const RobotState& state, Tick tick);

  /// The arrow back: the MPC puts these contacts where it decided, until it decides otherwise.
  /// plan() becomes what Update() would now give. A foot that is felt on the ground stays where it
  /// is felt, and a contact that is not in the plan is passed over. Takes no memory.
  void AdoptFootholds(const std::vector<Foothold>& footholds);

  /// Goes on from `support` (an edit of support(), see schedule_edits.h) instead; plan() with it.
  /// Decided footholds stay with contacts whose nominal place stays.
  void Adopt(const GaitSupport& support);

  /// What schedule() would be after Adopt(support); to compare several. Takes memory the first time
  /// that it writes to `schedule`, none after.
  void LayOut(const GaitSupport& support, ContactSchedule* schedule) const;

  /// What plan() would be after Adopt(support), of which `schedule` has been laid out. Takes memory
  /// the first time that it writes to `plan`, none after.
  static void TakePlan(const GaitSupport& support, const ContactSchedule& schedule,
                       ContactPlan* plan);

  const ContactPlan& plan() const { return plan_; }

  /// Whether a foot has landed at the last Update() before its time: plans made before do not know
  /// it. One that is waited for is in every plan, as about to land.
  bool has_landed_early() const { return has_landed_early_; }

  /// The plan with its landings and CoM knots, as adjusted and shifted as the plan.
  const ContactSchedule& schedule() const { return schedule_; }

  /// Nominal CoM motion at `tick`, from the last Update's to its horizon; shifted like the
  /// contacts.
  ComReference ReferenceAt(Tick tick) const { return NominalComAt(schedule_, tick, setup_.tick_s); }

  /// Where the gait is, and the setup it goes on from: what schedule_edits.h begins with.
  const GaitSupport& support() const { return support_; }
  const GaitSetup& setup() const { return setup_; }

 private:
  // What the MPC decided for a contact to come; where the gait has it, as Adopt() sees it.
  struct Decision {
    int index{0};
    Eigen::Vector3d p_WF{Eigen::Vector3d::Zero()};
    Eigen::Vector3d nominal_p_WF{Eigen::Vector3d::Zero()};
  };

  void TakeLandings(const RobotState& state);
  void Land(GaitSupport* next);
  void NoteFeltFeet(const RobotState& state);
  Eigen::Vector3d ShiftOf(const GaitSupport& support, int sequence) const;
  const Decision* DecisionOn(std::size_t foot, int index) const;
  void Note(const Foothold& foothold);
  void LayOutPlan();

  GaitSetup setup_;
  PlannerParams params_;
  Tick horizon_;
  TouchDownRule touch_downs_;
  Tick tick_{0};
  bool has_landed_early_{false};
  GaitSupport support_;
  std::array<bool, 2> is_felt_{};               // each foot's contact, at tick_
  std::vector<MovingFoot> moving_;              // the feet, at tick_
  std::vector<std::vector<Decision>> decided_;  // of each foot's contacts to come
  ContactSchedule schedule_;
  ContactPlan plan_;
};

}  // namespace sidestep
