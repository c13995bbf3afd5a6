// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// nlp_layout: which number of the sparse NLP means what.
//
// In : CentroidalOcp.     Out: columns of the variables, rows of the constraints.
// Variables, mass-normalised (momentum / m, force / m) so that robots of any size scale alike:
//   state k = 1..N : p (m), v = hp/m (m/s), l = hw/m (m^2/s)      (state 0 is data)
//   force slot     : u = f/m (m/s^2), world axes, one a vertex and knot of an active contact
//   free location  : d (m), with P = nominal + R d, so that the box is a bound on d
// Order: forces at knot 0, state 1, forces at knot 1, ..., state N, locations. Rows: nine of
// dynamics a knot, then friction_A.rows() a force slot.

#include <Eigen/Core>
#include <vector>

#include "controller/mpc/problem/centroidal_ocp.h"

namespace sidestep::mpc {

/// A contact location that the NLP decides.
struct FreeLocation {
  int contact{0};
  int phase{0};
  int column{0};     ///< First of three.
  int num_knots{0};  ///< Knots k <= N in the phase: how often its cost counts.
};

/// The force at one vertex at one knot.
struct ForceSlot {
  int contact{0};
  int phase{0};
  int vertex{0};
  int knot{0};
  int column{0};                   ///< First of three.
  int friction_row{0};             ///< First of friction_A.rows().
  int location{-1};                ///< Index of its FreeLocation, -1 if the phase is fixed.
  int next_slot{-1};               ///< Same vertex and phase at knot + 1; -1 if none.
  int previous_slot{-1};           ///< Same vertex and phase at knot - 1; -1 if none.
  bool has_previous_force{false};  ///< The force before the horizon is known and counts.
  bool is_new{false};              ///< Its phase starts at N - 1: new_contact_force counts.
  Eigen::Vector3d anchor_W{Eigen::Vector3d::Zero()};  ///< m; the vertex in W if d = 0.
};

/// What belongs to one knot.
struct KnotLayout {
  int state_column{-1};  ///< p at +0, v at +3, l at +6; -1 at k = 0.
  int first_slot{0};
  int end_slot{0};  ///< Equal to first_slot in flight and at k = N.
};

/// The layout of one problem. Rebuilding it for another schedule of the same horizon, contacts
/// and vertices does not allocate: storage is reserved for every contact active at every knot.
class NlpLayout {
 public:
  static constexpr int kStateSize = 9;

  /// Lays out `ocp`, whose shapes must have passed CheckShapes().
  void Build(const CentroidalOcp& ocp);

  int num_variables() const { return num_variables_; }
  int num_constraints() const { return num_constraints_; }
  /// First of the nine rows of the dynamics from knot k to k + 1.
  static int DynamicsRow(int k) { return kStateSize * k; }
  const std::vector<KnotLayout>& knots() const { return knots_; }
  /// All force slots, ordered by knot, contact, vertex.
  const std::vector<ForceSlot>& slots() const { return slots_; }
  const std::vector<FreeLocation>& locations() const { return locations_; }
  /// Index of the free location of a phase; -1 if it is fixed or beyond the horizon.
  int LocationIndex(int contact, int phase) const;

 private:
  void Reserve(const CentroidalOcp& ocp);
  void AddSlots(const CentroidalOcp& ocp, int contact, int k, int* column);

  std::vector<KnotLayout> knots_;
  std::vector<ForceSlot> slots_;
  std::vector<FreeLocation> locations_;
  int num_variables_{0};
  int num_constraints_{0};
};

}  // namespace sidestep::mpc
