// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// problem_view: one optimal control problem as the numerical core sees it: plain arrays.
//
// In : StructuredProblem lays a CentroidalOcp out.      Out: everything in isa namespaces.
// Quantities are mass-normalised: u = f/m (m/s^2), v = h^p/m (m/s), l = h^w/m (m^2/s).
// Forces of a stage are ordered by axis, then contact, then vertex (structure of arrays), so that
// loops over the vertices of a stage vectorise: component a of slot j is entry a * num_slots + j.

namespace sidestep::mpc::structured {

constexpr int kStateSize = 9;  ///< p at 0, v at 3, l at 6.
constexpr int kOneRow = 9;     ///< The constant follows the state in a stage's kept rows.

/// A contact that is active in a stage; its vertices are neighbouring slots.
struct ContactBlock {
  int first{0};      ///< First of its slots, counted within the stage.
  int count{0};      ///< Its vertices.
  int location{-1};  ///< Free location, -1 if its place is given.
  int previous{-1};  ///< First of its slots in stage k - 1, -1 if it was not on the ground.
  int next{-1};      ///< First of its slots in stage k + 1, -1 if it leaves or the horizon ends.
  int kept{0};       ///< Offset among the slots that continue from stage k - 1.
  int coupled{-1};   ///< Entry of its location in the stage's list of coupled locations.
  double share_square{1.0};  ///< Mean square of its slots' relative shares.
  bool has_shares{false};    ///< Its slots do not share alike.
  bool has_previous_force{false};
  double leg_anchor[3]{};  ///< R_WF offset - P if d = 0: r = p + this - R d.
  double leg_length{0.0};  ///< m; 0: no term.
  bool is_new{false};      ///< The last-input regularisation counts.
};

/// A location that couples to a stage, and its rows there.
struct CoupledLocation {
  int location{0};
  int row{0};         ///< First of three rows in this stage's matrix.
  int row_before{0};  ///< The same in stage k - 1's, if coupled there.
};

/// Neighbouring kept rows of stage k + 1 (not its state) and the rows of stage k that they are.
struct Carry {
  int from{0};  ///< Counted from stage k + 1's first kept row.
  int to{0};
  int count{0};
};

/// What the linear algebra of one stage needs to know. Rows of its matrix: pivots [u, locations
/// that start here, padding], kept [x, 1, locations that started before, padding], forces of
/// stage k - 1 that continue.
struct Stage {
  int first_block{0}, num_blocks{0};
  int first_slot{0}, num_slots{0};
  int first_coupled{0}, num_new{0}, num_coupled{0};
  int first_carry{0}, num_carries{0};  ///< From stage k + 1.
  int num_pivots{0};                   ///< Multiple of four.
  int first_of_pivots{0};              ///< Pivots of the stages before.
  int num_active{0};                   ///< Rows that the dynamics touch; multiple of four.
  int num_rows{0};                     ///< Multiple of four.
  int num_kept{0};                     ///< Slots that continue from stage k - 1.
  double* panel{nullptr};              ///< num_rows x num_pivots: the factor.
  double* inverse_pivot{nullptr};      ///< num_pivots.
  double* dynamics{nullptr};           ///< num_active x 9: transposed Jacobian of the next state;
                                       ///< zero until the first factorisation.
  int* first_pivot{nullptr};           ///< One each four rows: first pivot with a non-zero entry.
};

/// Where the parts of a point are in one flat array.
struct PointLayout {
  int u{0}, d{0}, s{0}, z{0}, lower{0}, upper{0}, size{0};  ///< x is at 0.
};

/// All data of a problem. Arrays belong to StructuredProblem.
struct ProblemView {
  int knots{0};
  int num_slots{0};
  int num_locations{0};
  int num_pivots{0};  ///< Of all stages.
  int num_faces{0};   ///< Rows of the friction description.
  double weight_leg{0.0};
  double weight_load{0.0};
  double load_limit{0.0};  ///< m/s^2.
  double weight_com[3]{}, weight_momentum[3]{}, weight_symmetry[3]{}, weight_rate[3]{},
      weight_new[3]{};                    ///< weight_rate is divided by T^2.
  const double* step_s{nullptr};          ///< N: T_k.
  const double* reference{nullptr};       ///< 9 x (N+1), v unused.
  const double* drift{nullptr};           ///< 6 x N: acceleration and torque / m without contacts.
  const double* anchor{nullptr};          ///< 3 x slots: vertices in W if d = 0, stage by stage.
  const double* face{nullptr};            ///< 3 faces x slots: rows in W, stage by stage.
  const double* bound{nullptr};           ///< faces.
  const double* relative_share{nullptr};  ///< slots, stage by stage: n s_j, 1 if shares are equal.
  const double* previous_u{nullptr};      ///< 3 x slots of stage 0.
  const double* rotation{nullptr};        ///< 9 a location, row-major R_WF.
  const double* location_hessian{nullptr};  ///< 9 a location, in F.
  const double* box_lower{nullptr};         ///< 3 a location.
  const double* box_upper{nullptr};         ///< 3 a location.
  const double* is_free{nullptr};           ///< 3 a location: 1, or 0 where the box has no size.
  Stage* stages{nullptr};                   ///< N + 1.
  const ContactBlock* blocks{nullptr};
  const CoupledLocation* coupled{nullptr};
  const Carry* carries{nullptr};
  PointLayout at;
};

}  // namespace sidestep::mpc::structured
