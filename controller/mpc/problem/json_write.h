// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// json_write: Eigen vectors and matrices as JSON arrays.

#include <Eigen/Core>
#include <nlohmann/json.hpp>

namespace sidestep::mpc {

/// A vector as an array of numbers.
inline nlohmann::json RowOf(const Eigen::Ref<const Eigen::VectorXd>& vector) {
  nlohmann::json row = nlohmann::json::array();
  for (Eigen::Index i = 0; i < vector.size(); ++i) {
    row.push_back(vector(i));
  }
  return row;
}

/// A 3 x n matrix as n arrays of three numbers.
inline nlohmann::json RowsOf(const Eigen::Matrix3Xd& columns) {
  nlohmann::json rows = nlohmann::json::array();
  for (Eigen::Index k = 0; k < columns.cols(); ++k) {
    rows.push_back(RowOf(columns.col(k)));
  }
  return rows;
}

}  // namespace sidestep::mpc
