// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// gait_writer: the one place that knows how the gaits step. It walks through time, one support
// after the other, and writes contacts and CoM knots down. For the room's other files; from outside
// see gait_generator.h and nominal_gait.h.
//
// Sources of the CoM's knots: over the middle of the feet in the middle of each support; with
// GaitGeometry::sway also in the middle of a walk's swing, towards the foot that stands; of a
// run or hop also in the middle of each flight, halfway between the supports, with the height of a
// bounce (bounce.h).

#include <array>
#include <optional>

#include "controller/planner/contact_schedule.h"
#include "controller/planner/gait_setup.h"
#include "controller/planner/gait_support.h"
#include "controller/planner/sway.h"
#include "controller/types/gait_params.h"
#include "controller/types/tick.h"

namespace sidestep {

class GaitWriter {
 public:
  /// Goes on from `support`. Writes to `schedule` (which must be empty and outlive the writer): its
  /// standing contacts and passed knots first, then what each step adds. Null: writes nothing.
  GaitWriter(const GaitSetup& setup, const GaitSupport& support, ContactSchedule* schedule);

  /// Puts all feet on the ground at tick 0, side by side at the path's begin.
  void StandAtTheBegin();

  /// Makes the step or stand that the support leads to: support() is the next one. False if it
  /// stands for good: no more comes but the knot at which it comes to rest. Throws
  /// ContractViolation if the gait is for another number of feet or takes no time.
  bool Step();

  /// The step that Step() makes next: what was ordered, or the segment that is on.
  GaitParams NextGait() const;

  /// As far as was written. Its contacts that have no end stand there.
  const GaitSupport& support() const { return support_; }

  /// When the last step had `foot` leave the ground, if it did.
  const std::optional<Tick>& lift_off(int foot) const {
    return lift_offs_[static_cast<std::size_t>(foot)];
  }

  /// All feet on the ground, at one place of the path.
  bool FeetSideBySide() const;

  /// Puts the CoM over the middle of the feet that stand, y on the path.
  void AddComKnot(Tick tick, bool at_rest, double haste = 1.0);

  /// Contacts without an end get one that is no earlier than `tick`, and stay of unknown end.
  void CloseAt(Tick tick);

 private:
  Tick Ticks(double time_s) const { return TickAt(time_s, setup_.tick_s); }
  FootSupport& Foot(int foot) { return support_.feet[static_cast<std::size_t>(foot)]; }
  const FootSupport& Foot(int foot) const { return support_.feet[static_cast<std::size_t>(foot)]; }
  double FootX(int foot) const { return Foot(foot).nominal.contact.nominal_p_WF.x(); }
  /// The time from a lift-off to the next landing that the gait gives, as ordered, and no less than
  /// `least`.
  Tick Moved(Tick in_the_air, Tick least) const;
  /// What was ordered of it; by nothing if nothing was.
  TouchDownMove MoveOfNextLanding() const;
  std::optional<Tick> NextSegmentStart() const;
  /// Begins a contact of `foot` at `tick`, where the path has it by now.
  void Land(int foot, Tick tick, const GaitParams& gait);
  void BeginOrder();
  void EndOrder();
  /// Ends the contact that `foot` stands in.
  void LiftOff(int foot, Tick tick);
  /// Writes a knot of the path as it is now.
  void AddKnot(ComKnot knot);
  void AddSwayKnot(Tick tick, int stance, const GaitParams& gait, const Sway& sway);
  /// In the middle of the support by `foot` that ends at `lift_off`, and of the flight after it.
  void AddBounceKnots(int foot, Tick lift_off, const GaitParams& gait);
  bool Stand();
  void WalkStep(const GaitParams& gait);
  void RunStep(const GaitParams& gait);
  void HopStep(const GaitParams& gait);
  /// Moves the path on by a step and lands `foot` there.
  void Advance(int foot, Tick landing, const GaitParams& gait);

  const GaitSetup& setup_;
  GaitSupport support_;
  ContactSchedule* schedule_;
  std::array<std::optional<Tick>, 2> lift_offs_;  // of the last step
};

}  // namespace sidestep
