// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// wrench: force and moment, [linear; angular] as everywhere in the program.

#include <Eigen/Core>

namespace sidestep {

/// A force with its moment about a stated point, both expressed in a stated frame.
struct Wrench {
  Eigen::Vector3d force_N{Eigen::Vector3d::Zero()};
  Eigen::Vector3d torque_Nm{Eigen::Vector3d::Zero()};
};

}  // namespace sidestep
