// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// column_path: where a column of trajectory.csv stands in the tree that viewers show.
//
// One table for every format that is exported. `truth_p_WC_x_m` is truth/com/position, element x,
// in m; `joint_knee_rad` is joints_state/positions, element knee, in rad, as iCub's viewers call
// it. A column that the table does not know is other/<its name>.

#include <string>
#include <string_view>
#include <vector>

namespace sidestep {

struct ColumnPath {
  std::vector<std::string> group;  ///< From the root: truth, com, position. At least one.
  std::string element;             ///< Of that group's vector: x, w, a joint; empty: it has one.
  std::string unit;                ///< As the column's name ends; empty for a plain number.
};

ColumnPath PathOf(std::string_view column);

/// The path in one word, with its unit: truth/com/position/x_m, truth/base/tilt_rad.
std::string PathText(const ColumnPath& path);

}  // namespace sidestep
