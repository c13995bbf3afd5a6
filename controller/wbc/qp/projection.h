// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// projection: the point of a polyhedron nearest to a given one, by the dual active-set method.
//
//   minimise 1/2 |y - y_0|^2    subject to    lower <= N' y <= upper,    columns of N of norm 1
//
// Any strictly convex QP takes this form in the coordinates where its Hessian is the identity;
// there Goldfarb & Idnani's J is just an orthogonal Q, slacks are distances, and whether a new
// row depends on the active ones is a question of angle, whatever the units were.

#include <Eigen/Core>

#include "controller/wbc/qp/kernels.h"

namespace sidestep::wbc::internal {

/// kEmpty: no y meets the rows, proved by the active ones. kIterationLimit: out of changes, y may
/// still violate rows.
enum class ProjectionStatus { kSolved, kEmpty, kIterationLimit };

enum class Side { kLower, kUpper };

/// Keeps its active set between calls of Solve, so that a nearby problem starts from it.
class Projection {
 public:
  /// Takes memory for y of size `max_dimension` and `max_rows` constraints.
  Projection(int max_dimension, int max_rows);

  /// Sets the sizes and empties the active set. The data below must then be filled in.
  void Reset(int dimension, int rows);

  /// N, dimension x rows.
  auto normals() { return normals_.topLeftCorner(dimension_, rows_); }
  auto lower() { return lower_.head(rows_); }
  auto upper() { return upper_.head(rows_); }
  /// Violations up to this are accepted, row by row.
  auto slack() { return slack_.head(rows_); }

  /// Puts a row in the active set unless it depends on those there, or its bound is infinite.
  void TryActivate(int row, Side side);

  /// Projects `target`, spending at most `max_changes` active-set changes.
  ProjectionStatus Solve(const ConstVectorRef& target, int max_changes);

  auto y() const { return y_.head(dimension_); }
  int changes() const { return changes_; }  ///< Spent by the last Solve.
  int active_count() const { return active_; }
  int active_row(int k) const { return row_(k); }
  /// Multiplier of active row k: > 0 at its upper bound, < 0 at its lower, in
  /// y - y_0 + N multipliers = 0.
  double signed_multiplier(int k) const { return -sign_(k) * multiplier_(k); }

 private:
  enum class Step { kFull, kDropped, kEmpty, kIgnored };

  /// Takes in the row whose normal is in rotated_; false if it depends on the active ones.
  bool Append(int row, double sign);
  /// Drops active row k, and turns Q so that R is triangular again.
  void Remove(int k);
  /// y and multipliers from the active rows alone.
  void SolveActiveSet();
  void DropNegativeMultipliers();
  int MostViolated() const;
  /// A step of the dual method towards the bound of a violated row.
  Step StepTowards(int row, double sign, double& new_multiplier);
  ProjectionStatus Enforce(int row, int max_changes);
  bool IsProof(int row, double sign) const;
  double BoundOf(int row, double sign) const { return sign > 0.0 ? lower_(row) : -upper_(row); }

  int dimension_{0};
  int rows_{0};
  int active_{0};
  int changes_{0};
  Eigen::MatrixXd normals_;
  Eigen::VectorXd lower_, upper_, slack_;  // one a row
  Eigen::VectorXd y_, values_;
  // Active rows as sign * n' y >= bound; their normals are Q [R; 0].
  Eigen::MatrixXd q_, r_;
  Eigen::VectorXd rotated_target_;  // Q' y_0, turned along with Q
  Eigen::VectorXi row_;             // of each active one
  Eigen::VectorXd sign_, multiplier_;
  Eigen::VectorXd rotated_;       // Q' times the normal being added
  Eigen::VectorXd coefficients_;  // of the part of that normal that the active ones span
  Eigen::VectorXd buffer_;
  Eigen::Array<bool, Eigen::Dynamic, 1> is_skipped_;  // active, or too ill-conditioned to enforce
};

}  // namespace sidestep::wbc::internal
