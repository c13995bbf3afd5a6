// SPDX-License-Identifier: BSD-3-Clause
#include "controller/mpc/shifted_guess.h"

#include <algorithm>

#include "controller/mpc/problem/solution_shape.h"
#include "models/support/require.h"

namespace sidestep::mpc {
namespace {

/// A contact that touched down this close to the previous horizon's end restarts its forces.
constexpr int kRestartKnots = 2;

/// The phase of `previous`, from index `first` on, that overlaps most with `phase` when that is
/// moved `shift` knots later; -1 if none does. A phase that the previous horizon saw end still
/// ends there; what lies beyond the horizon is compared as planned.
int FindPredecessor(const OcpContact& previous, const ContactPhase& phase, int shift, int first) {
  int best = -1;
  int best_overlap = 0;
  for (int q = first; q < static_cast<int>(previous.phases.size()); ++q) {
    const ContactPhase& candidate = previous.phases[static_cast<std::size_t>(q)];
    const int overlap = std::min(candidate.end_knot, phase.end_knot + shift) -
                        std::max(candidate.first_knot, phase.first_knot + shift);
    if (overlap > best_overlap) {
      best = q;
      best_overlap = overlap;
    }
  }
  return best;
}

struct Shift {
  const CentroidalOcp& previous_ocp;
  const MpcSolution& previous;
  int knots;
  const CentroidalOcp& next_ocp;
};

void ShiftStates(const Shift& shift, MpcSolution* guess) {
  const int last = shift.previous_ocp.knots;
  for (int k = 1; k <= shift.next_ocp.knots; ++k) {
    const int source = std::min(k + shift.knots, last);
    const double beyond_s = shift.next_ocp.step_s * (k + shift.knots - source);
    guess->linear_momentum.col(k) = shift.previous.linear_momentum.col(source);
    guess->angular_momentum.col(k) = shift.previous.angular_momentum.col(source);
    guess->p_WC.col(k) =
        shift.previous.p_WC.col(source) +
        (beyond_s / shift.previous_ocp.mass_kg) * shift.previous.linear_momentum.col(source);
  }
  guess->p_WC.col(0) = shift.next_ocp.initial_p_WC;
  guess->linear_momentum.col(0) = shift.next_ocp.initial_linear_momentum;
  guess->angular_momentum.col(0) = shift.next_ocp.initial_angular_momentum;
}

/// Fills the forces of phase q of contact i, whose predecessor is phase `predecessor` or -1.
void ShiftForces(const Shift& shift, std::size_t i, const ContactPhase& phase, int predecessor,
                 MpcSolution* guess) {
  const int last_input = shift.previous_ocp.knots - 1;
  int source_first = 0;
  int source_last = -1;  // Empty: restart.
  if (predecessor >= 0) {
    const ContactPhase& before =
        shift.previous_ocp.contacts[i].phases[static_cast<std::size_t>(predecessor)];
    const bool just_appeared =
        before.first_knot > 0 && before.first_knot > last_input - kRestartKnots;
    if (!just_appeared) {
      source_first = before.first_knot;
      source_last = std::min(before.end_knot - 1, last_input);
    }
  }
  for (int k = phase.first_knot; k < std::min(phase.end_knot, shift.next_ocp.knots); ++k) {
    Eigen::Matrix3Xd& force_N = guess->contacts[i].force_N[static_cast<std::size_t>(k)];
    if (source_last < source_first) {
      force_N.colwise() = WeightShare(shift.next_ocp, k);
    } else {
      const int source = std::clamp(k + shift.knots, source_first, source_last);
      force_N = shift.previous.contacts[i].force_N[static_cast<std::size_t>(source)];
    }
  }
}

void ShiftContact(const Shift& shift, std::size_t i, MpcSolution* guess) {
  const OcpContact& before = shift.previous_ocp.contacts[i];
  const OcpContact& contact = shift.next_ocp.contacts[i];
  int first = 0;
  for (std::size_t q = 0; q < contact.phases.size(); ++q) {
    const ContactPhase& phase = contact.phases[q];
    const int predecessor = FindPredecessor(before, phase, shift.knots, first);
    if (predecessor >= 0) {
      first = predecessor + 1;
      if (!phase.fixed && predecessor >= 0) {
        guess->contacts[i].phase_p_WF[q] =
            shift.previous.contacts[i].phase_p_WF[static_cast<std::size_t>(predecessor)];
      }
    }
    ShiftForces(shift, i, phase, predecessor, guess);
  }
}

}  // namespace

void ShiftedGuess(const CentroidalOcp& previous_ocp, const MpcSolution& previous, int shift_knots,
                  const CentroidalOcp& next_ocp, MpcSolution* guess) {
  SIDESTEP_REQUIRE(shift_knots >= 0, shift_knots);
  SIDESTEP_REQUIRE(HasShape(previous_ocp, previous), "a solution of other shapes");
  SIDESTEP_REQUIRE(previous_ocp.contacts.size() == next_ocp.contacts.size(),
                   next_ocp.contacts.size());
  for (std::size_t i = 0; i < next_ocp.contacts.size(); ++i) {
    SIDESTEP_REQUIRE(
        previous_ocp.contacts[i].vertices_m.cols() == next_ocp.contacts[i].vertices_m.cols(),
        next_ocp.contacts[i].vertices_m.cols());
  }
  ResetToShape(next_ocp, guess);
  const Shift shift{previous_ocp, previous, shift_knots, next_ocp};
  ShiftStates(shift, guess);
  for (std::size_t i = 0; i < next_ocp.contacts.size(); ++i) {
    ShiftContact(shift, i, guess);
  }
}

}  // namespace sidestep::mpc
