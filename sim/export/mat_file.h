// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// mat_file: signals as a MATLAB file of version 7.3, which is HDF5, laid out as iCub's logger has
// its own, so that MATLAB, h5py and robot-log-visualizer read it.
//
// One struct `robot_logger_device`: `description_list` (names of the joints), `yarp_robot_name`,
// and structs within structs as the signals' groups are. A signal is a struct of
//   data              n x 1 x rows of doubles, what the log says to its last digit; NaN: not told
//   timestamps        1 x rows (s), of the run
//   elements_names, units_of_measure   n x 1 cells
//   dimensions        [n; 1]
//   name              its last name
// The robot's true pose stands twice: with the other truth, and as base_position and
// base_orientation (x, y, z, w) at the root, for viewers that draw the robot.
// The layout is that of https://github.com/robotology/robometry.

#include <filesystem>
#include <string>
#include <vector>

#include "sim/export/signal.h"

namespace sidestep {

struct MatContent {
  std::string robot_name;
  std::vector<double> time_s;
  std::vector<Signal> signals;  ///< Each of as many rows as time_s.
};

/// Writes the whole file under a temporary name, then renames it. Names become what MATLAB takes:
/// letters, digits and underscores. @throws ConfigError if it can't be written.
void WriteMat(const MatContent& content, const std::filesystem::path& file);

}  // namespace sidestep
