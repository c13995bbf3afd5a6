// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// qp_builder: gathers tasks and constraints into one quadratic program, row by row.
//
//   minimise  1/2 sum_i |J_i x - target_i|^2_w_i     subject to  A x = b,  lower <= C x <= upper
//
// so that H = sum J' W J and g = -sum J' W target. The robot's velocities or accelerations are the
// first nv variables; what else there is (contact forces) comes after them. All memory is taken at
// construction: a problem may be smaller from tick to tick.

#include <Eigen/Core>
#include <array>
#include <span>

#include "controller/wbc/qp/dense_qp.h"
#include "controller/wbc/tasks.h"

namespace sidestep::wbc {

/// x, y and z.
inline constexpr std::array<int, 3> kAllAxes{0, 1, 2};

/// Rows of A x = b to be written to; zero so far.
struct EqualityRows {
  Eigen::Ref<Eigen::MatrixXd> A;  ///< rows x variables
  Eigen::Ref<Eigen::VectorXd> b;
};

/// Rows of lower <= C x <= upper to be written to; zero and unbounded so far.
struct InequalityRows {
  Eigen::Ref<Eigen::MatrixXd> C;  ///< rows x variables
  Eigen::Ref<Eigen::VectorXd> lower, upper;
};

class QpBuilder {
 public:
  /// Takes memory for problems up to `maxima`.
  explicit QpBuilder(const DenseQpDimensions& maxima);

  /// Begins a problem of so many variables: no task, no row.
  void Start(Eigen::Index variables);

  /// Weighs a task, all its rows alike.
  void AddTask(const Task& task, double weight);

  /// Weighs those of its rows x, y and z that `axes` names.
  void AddTask(const Task& task, double weight, std::span<const int> axes);

  /// Weighs |J y - target|^2 by one figure, where y are the variables from `first` on, as many as J
  /// (3 rows) has columns.
  void AddTaskOn(Eigen::Index first, const Eigen::Ref<const Eigen::MatrixXd>& J,
                 const Eigen::Vector3d& target, double weight);

  /// Weighs (x_i - target)^2 for one variable: posture, planned forces.
  void AddDiagonal(Eigen::Index variable, double target, double weight);

  /// Makes a task exact: its rows come after those so far. `axes` are those of x, y, z that the
  /// robot can do anything about, all by default: a row without a freedom would only contradict.
  void AddExact(const Task& task, std::span<const int> axes = kAllAxes);

  /// Adds rows that the caller fills in before the next Start(). Throw ContractViolation beyond the
  /// maxima, as AddExact() does.
  EqualityRows AddEqualities(Eigen::Index rows);
  InequalityRows AddInequalities(Eigen::Index rows);

  /// Gives up the last `rows` equalities.
  void DropEqualities(Eigen::Index rows);

  /// The problem so far. Valid until this changes.
  DenseQpView View() const;

 private:
  DenseQpProblem qp_;  // at its largest; blocks of it are in use
  Eigen::Index variables_{0}, equalities_{0}, inequalities_{0};
};

}  // namespace sidestep::wbc
