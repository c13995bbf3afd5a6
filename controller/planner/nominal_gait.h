// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// nominal_gait: the whole nominal contact sequence of an episode, from its gait parameters.
//
// Contacts are numbered by a landing count `sequence` over all feet, so that a shift of the path
// can be attached to the landing that caused it. The robot starts standing, feet side by side.

#include <Eigen/Core>
#include <vector>

#include "controller/types/contact_plan.h"
#include "controller/types/gait_params.h"
#include "controller/types/tick.h"

namespace sidestep {

/// A contact of the nominal gait and the landing it began with (0: stood there at the start).
struct NominalContact {
  PlannedContact contact;
  int sequence{0};
  bool decided{false};  ///< The MPC has placed it; until then it is where the gait wants it.
  Eigen::Vector3d landing_shift{Eigen::Vector3d::Zero()};  ///< Of nominal_p_WF, once it landed.
};

/// The CoM reference passes through `p_WC` at `tick`; the ground track belongs to the contacts of
/// landing `sequence`.
struct ComKnot {
  Tick tick{0};
  Eigen::Vector3d p_WC{Eigen::Vector3d::Zero()};
  int sequence{0};
  bool at_rest{false};  ///< Zero velocity here; elsewhere it is set by the neighbours.
};

struct NominalGait {
  std::vector<std::vector<NominalContact>> feet;
  std::vector<ComKnot> com;  ///< By increasing tick; at least two.
};

/// What the gait must know of the robot.
struct GaitGeometry {
  int num_feet{1};            ///< 1 or 2; foot 0 of two is the left one (+y).
  double com_height_m{0.5};   ///< Above the ground.
  double sole_height_m{0.0};  ///< Height of F in stance.
  /// Bounds of a step's adjustment in the contact frame (m), of a single or left foot; the right
  /// foot's are mirrored in y.
  Eigen::Vector3d box_lower_m{Eigen::Vector3d::Zero()};
  Eigen::Vector3d box_upper_m{Eigen::Vector3d::Zero()};
  double com_sway{0.0};  ///< PlannerParams::com_sway.
};

/// Lays contacts out until `end_tick` at least. `segments` are in order of start_s, the first at 0.
/// Contacts that last to the end have a far end_tick. Throws ContractViolation without segments.
NominalGait BuildNominalGait(const std::vector<GaitParams>& segments, const GaitGeometry& geometry,
                             Tick end_tick, double tick_s);

/// Rewrites `gait` from `tick` on, when every foot stands: `recovery.steps` quick steps on the
/// spot, `first_foot` first, then the segments again. Contacts that have not begun are forgotten.
void InsertRecovery(const RecoveryParams& recovery, int first_foot,
                    const std::vector<GaitParams>& segments, const GaitGeometry& geometry,
                    Tick tick, Tick end_tick, double tick_s, NominalGait* gait);

}  // namespace sidestep
