// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// solution_difference: how far two answers of the MPC's back ends are apart.

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "controller/mpc/problem/centroidal_ocp.h"
#include "controller/mpc/problem/mpc_solution.h"

namespace sidestep::mpc {

/// Two answers to one problem, both usable.
struct Difference {
  double cost{0.0};     ///< Relative, of the second over the first; negative if it is lower.
  double force{0.0};    ///< Of body weight.
  double place_m{0.0};  ///< Of the contacts.

  /// Farther apart in cost than rounding and tolerances explain: two local minima.
  bool is_other_minimum() const { return std::abs(cost) > 1e-6; }
};

inline Difference Compare(const CentroidalOcp& ocp, const MpcSolution& first,
                          const MpcSolution& second) {
  Difference difference;
  difference.cost = (second.cost - first.cost) / std::max(std::abs(first.cost), 1e-9);
  const double weight_N = ocp.mass_kg * ocp.gravity_mps2.norm();
  for (std::size_t i = 0; i < ocp.contacts.size(); ++i) {
    const ContactSolution& a = first.contacts[i];
    const ContactSolution& b = second.contacts[i];
    for (std::size_t k = 0; k < a.force_N.size(); ++k) {
      difference.force = std::max(difference.force,
                                  (a.force_N[k] - b.force_N[k]).cwiseAbs().maxCoeff() / weight_N);
    }
    for (std::size_t q = 0; q < a.phase_p_WF.size(); ++q) {
      difference.place_m =
          std::max(difference.place_m, (a.phase_p_WF[q] - b.phase_p_WF[q]).cwiseAbs().maxCoeff());
    }
  }
  return difference;
}

}  // namespace sidestep::mpc
