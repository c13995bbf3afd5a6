// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// locomotion_controller: the control chain. Read the .cc: it is the table of contents.

#include <memory>
#include <optional>
#include <vector>

#include "controller/estimator/state_estimator.h"
#include "controller/estimator/truth_estimator.h"
#include "controller/model/rigid_body.h"
#include "controller/mpc/centroidal_mpc.h"
#include "controller/planner/gait_planner.h"
#include "controller/swing/swing_foot.h"
#include "controller/types/control_params.h"
#include "controller/types/control_tick.h"
#include "controller/types/sensor_frame.h"
#include "controller/types/stage_timer.h"
#include "controller/wbc/whole_body.h"
#include "models/robot_description/robot_description.h"

namespace sidestep {

/// What decides a controller. The robot is the nominal one: the plant may differ from it.
struct LocomotionSetup {
  RobotDescription robot;
  ControlParams control;
  std::vector<GaitParams> gait;
  bool is_centroidal{false};  ///< The plant has no joints; forces are the command.
  double tick_s{0.001};       ///< One tick.
  double duration_s{10.0};    ///< The nominal gait is laid out this far and a horizon more.
};

class LocomotionController {
 public:
  /// `timer` must outlive the controller. Throws ConfigError if the robot's MJCF does not compile.
  LocomotionController(const LocomotionSetup& setup, StageTimer* timer);

  /// One control tick. The reference stays valid until the next call.
  const ControlTick& Update(const SensorFrame& frame);

  /// The last MPC problem, for dumps.
  const mpc::CentroidalOcp& last_problem() const { return mpc_.problem(); }

 private:
  void Estimate(const SensorFrame& frame);
  void Plan();
  void SolveMpc();
  void TargetFeet();
  void SampleReferences();
  void TargetFoot(std::size_t foot);
  void Command();
  bool IsMpcTick() const { return tick_.tick % mpc_period_ == 0; }
  const GaitParams& GaitAt(Tick tick) const;

  LocomotionSetup setup_;
  StageTimer* timer_;
  Tick mpc_period_;
  std::unique_ptr<RigidBody> rigid_body_;                    // none on the centroidal plant
  std::unique_ptr<StateEstimator> estimator_;                // none on the centroidal plant
  std::optional<CentroidalEstimator> centroidal_estimator_;  // only there
  GaitPlanner planner_;
  mpc::CentroidalMpc mpc_;
  mpc::GridReferences references_;
  std::vector<SwingFoot> swing_;
  std::unique_ptr<wbc::WholeBody> whole_body_;  // none if passive or on the centroidal plant
  ControlTick tick_;
};

}  // namespace sidestep
