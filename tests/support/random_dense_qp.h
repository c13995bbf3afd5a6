// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// random_dense_qp: families of random QPs with a known feasible point, the same on every machine.

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <random>

#include "controller/wbc/qp/dense_qp.h"

namespace sidestep::wbc {

enum class QpFamily {
  kStrictlyConvex,
  kSemiDefinite,      ///< H of half rank; bounds on every variable keep the optimum finite.
  kLinear,            ///< H = 0, bounded as above: an LP.
  kDuplicateRows,     ///< Repeated, scaled and summed rows in A and in C.
  kPins,              ///< A third of the rows with lower == upper.
  kBadlyScaled,       ///< Variables over 10^+-2, rows of A and C over 10^+-2.
  kDegenerateVertex,  ///< More than n rows of C meet in the feasible point.
  kHopper,            ///< 12 variables, 9 equalities, 16 inequalities.
  kVelocity,          ///< 29 variables, 15 equalities, 46 rows bounding single variables.
  kTorque,            ///< 29 accelerations, 24 corner forces, 6 slacks; A of deficient rank.
};

constexpr QpFamily kAllQpFamilies[] = {QpFamily::kStrictlyConvex,
                                       QpFamily::kSemiDefinite,
                                       QpFamily::kLinear,
                                       QpFamily::kDuplicateRows,
                                       QpFamily::kPins,
                                       QpFamily::kBadlyScaled,
                                       QpFamily::kDegenerateVertex,
                                       QpFamily::kHopper,
                                       QpFamily::kVelocity,
                                       QpFamily::kTorque};

const char* ToString(QpFamily family);

/// Whether the optimum x of such problems is unique.
bool IsStrictlyConvex(QpFamily family);

/// Uniform and normal numbers whose sequence does not depend on the standard library.
class SeededNumbers {
 public:
  explicit SeededNumbers(std::uint64_t seed) : engine_(seed) {}
  double Uniform(double low, double high);
  double Normal();
  int Integer(int low, int high);  ///< Both inclusive.
  Eigen::MatrixXd NormalMatrix(Eigen::Index rows, Eigen::Index cols);
  Eigen::Vector3d Vector3(double size);      ///< Each entry within +-size.
  Eigen::Quaterniond Turn(double size_rad);  ///< About such a vector, by its length.

 private:
  std::mt19937_64 engine_;
};

/// F F' / sqrt(size) + shift I with F size x rank of normal numbers.
Eigen::MatrixXd RandomPositiveDefinite(SeededNumbers& numbers, int size, int rank, double shift);

/// Problem number `seed` of a family; feasible by construction, and bounded.
DenseQpProblem MakeRandomQp(QpFamily family, std::uint64_t seed);

/// A tick-to-tick neighbour of `problem`: g, b and the finite bounds move a little, b and bounds
/// together so that the feasible point moves along.
DenseQpProblem MakeNeighbourQp(const DenseQpProblem& problem, std::uint64_t seed);

/// Sizes that hold every problem of every family.
DenseQpDimensions RandomQpMaxima();

}  // namespace sidestep::wbc
