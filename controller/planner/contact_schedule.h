// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// contact_schedule: a stretch of gait as a value: who stands where and when, and how the CoM goes.
//
// Contacts are numbered by a landing count `sequence` over all feet, so that a shift of the path
// can be attached to the landing that caused it. A schedule of a horizon (gait_generator.h) and the
// nominal gait of a whole episode (nominal_gait.h) are the same type, written by the same writer.

#include <Eigen/Core>
#include <vector>

#include "controller/types/contact_plan.h"
#include "controller/types/tick.h"

namespace sidestep {

/// A contact of the gait and the landing it began with (0: stood there at the start).
struct NominalContact {
  PlannedContact contact;
  int sequence{0};
  /// How far (m) the path had been shifted when it landed; zero before, and in a nominal gait.
  Eigen::Vector3d shift{Eigen::Vector3d::Zero()};
};

/// The CoM reference passes through `p_WC` (m) at `tick`; the ground track belongs to the contacts
/// of landing `sequence`.
struct ComKnot {
  Tick tick{0};
  Eigen::Vector3d p_WC{Eigen::Vector3d::Zero()};
  int sequence{0};
  bool at_rest{false};  ///< Zero velocity here; elsewhere it is set by the neighbours,
  double haste{1.0};    ///< and along y so many times that: of a pendulum's sway.
  Eigen::Vector3d a_WC{Eigen::Vector3d::Zero()};  ///< Here (m/s^2): of a bounce, or a sway.
  /// As a contact's, of the landing `sequence`.
  Eigen::Vector3d shift{Eigen::Vector3d::Zero()};
};

struct ContactSchedule {
  std::vector<std::vector<NominalContact>> feet;  ///< Each foot's contacts by time.
  std::vector<ComKnot> com;                       ///< By time; never empty.
};

/// CoM motion of `schedule` at `tick`: quintic between the knots, at rest before the first and
/// after the last. Exact wherever there are two knots on either side, or the gait begins or rests
/// there. The knots' `shift` is not added.
/// @param tick_s  One tick.
ComReference NominalComAt(const ContactSchedule& schedule, Tick tick, double tick_s);

}  // namespace sidestep
