// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// gait_support: where a gait is at one moment, as a small value; all that comes follows from it.
//
// A support lasts from one touch-down to the next (a stand's from its begin to its end). It tells
// which feet stand where since when, which one steps next, where the path is, and, where that is
// not for the gait's segments to say, what has been ordered to come next (schedule_edits.h).

#include <array>
#include <optional>

#include "controller/planner/contact_schedule.h"
#include "controller/types/gait_params.h"
#include "controller/types/tick.h"

namespace sidestep {

/// A foot's latest contact: the one it stands in, or the one it left last.
struct FootSupport {
  NominalContact nominal;
  double path_y_m{0.0};  ///< y of the path where it landed.

  /// Its contact has not been given an end.
  bool stands() const { return !nominal.contact.end_is_known; }
};

/// The next steps, before the segments have their say again.
struct StepOrder {
  GaitParams gait;
  int steps{0};        ///< Still to be made; 0: no order.
  int first_foot{-1};  ///< Of the first of them; -1: whose turn it is.
};

/// The touch-down that begins landing `sequence` comes this much later (earlier if negative).
struct TouchDownMove {
  int sequence{0};  ///< Of no effect once it has landed.
  Tick by{0};
  Tick waited{0};  ///< The part of `by` for which a foot that was due has been waited for.
};

/// What departs from the segments. Without any, the segments say what comes.
struct GaitOrders {
  std::array<StepOrder, 2> next;      ///< Made in this order.
  std::optional<GaitParams> instead;  ///< Of all segments, from then on.
  std::array<TouchDownMove, 4> moves;
};

/// Where the gait is from `tick` to the next touch-down. A value: copies are independent.
struct GaitSupport {
  Tick tick{0};                     ///< Begin: the last touch-down, or a stand's end.
  std::array<FootSupport, 2> feet;  ///< The first num_feet of them count.
  int next_foot{0};                 ///< Whose turn it is to step.
  int sequence{0};                  ///< Of the last landing.
  double path_x_m{0.0};             ///< Of the last landing, without shifts.
  double path_y_m{0.0};
  /// Of the path (m), set at the last landing; who generates a nominal gait leaves it at zero.
  Eigen::Vector3d shift{Eigen::Vector3d::Zero()};
  std::optional<GaitParams> previous;  ///< Gait of the step or stand that led here.
  std::array<ComKnot, 2> passed;       ///< The last CoM knots up to `tick`, by time,
  std::size_t num_passed{0};           ///< and how many there are: 1 at the begin.
  GaitOrders orders;

  /// Appends to the passed knots; the oldest goes if they are full.
  void Pass(const ComKnot& knot) {
    if (num_passed == passed.size()) {
      passed = {passed[1], knot};
    } else {
      passed[num_passed++] = knot;
    }
  }

  const ComKnot& last_passed() const { return passed[num_passed - 1]; }
};

}  // namespace sidestep
