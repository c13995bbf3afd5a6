// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// signal: the columns of a trajectory that belong together, as one vector over time.

#include <string>
#include <vector>

#include "sim/record/run_reader.h"

namespace sidestep {

struct Signal {
  std::vector<std::string> group;     ///< Its place, from the root.
  std::vector<std::string> elements;  ///< Names: x, y, z; one element has its group's last name.
  std::vector<std::string> units;     ///< Of each element.
  std::vector<std::vector<double>> values;  ///< Of each element, a number a row.
};

/// All signals of a trajectory but its time, in the order in which they first come.
std::vector<Signal> SignalsOf(const CsvTable& trajectory);

}  // namespace sidestep
