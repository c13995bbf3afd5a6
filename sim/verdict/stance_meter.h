// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// stance_meter: when one foot stands, by what the ground does to it.
//
// A stance begins when the foot touches the ground and bears load, whatever anybody planned, and
// ends when it has been off the ground for more than 10 ms: a bounce belongs to it. A foot that
// only touches, without load, neither begins a stance nor ends one.

#include "controller/types/tick.h"
#include "sim/world/world.h"

namespace sidestep {

/// A loss of contact, or of load, that is no longer (s) belongs to the stance.
constexpr double kBounce_s = 0.01;

class StanceMeter {
 public:
  /// @param tick_s  Length of a tick. @param min_load_N  Vertical force of a foot that bears load.
  StanceMeter(double tick_s, double min_load_N) : tick_s_(tick_s), min_load_N_(min_load_N) {}

  /// Takes one tick; ticks ascend.
  void Add(Tick tick, const FootTruth& foot);

  /// A stance is under way.
  bool stands() const { return stands_; }

  /// It bears load at the last tick.
  bool bears_load() const { return bears_load_; }

  /// It bears load, and its stance is 10 ms old: a landing may settle, and a compliant contact
  /// rings shorter.
  bool bears_settled_load() const { return bears_load_ && is_settled_; }

  /// Stances that have begun so far, the one under way included.
  int num_stances() const { return num_stances_; }

 private:
  double tick_s_;
  double min_load_N_;
  bool stands_{false};
  bool bears_load_{false};
  bool is_settled_{false};
  int num_stances_{0};
  Tick start_tick_{0};         // of the latest stance
  Tick last_contact_tick_{0};  // of its ticks on the ground so far
};

}  // namespace sidestep
