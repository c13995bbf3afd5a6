// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// quaternion: the one converter between MuJoCo's w,x,y,z and Eigen's quaternions.

#include <mujoco/mujoco.h>

#include <Eigen/Geometry>

namespace sidestep {

/// Reads four numbers in the order w, x, y, z.
/// Eigen stores x, y, z, w but constructs from w, x, y, z. Not normalised: MuJoCo's are.
inline Eigen::Quaterniond FromMuJoCo(const mjtNum* wxyz) {
  return {wxyz[0], wxyz[1], wxyz[2], wxyz[3]};
}

/// Writes four numbers in the order w, x, y, z.
inline void ToMuJoCo(const Eigen::Quaterniond& q, mjtNum* wxyz) {
  wxyz[0] = q.w();
  wxyz[1] = q.x();
  wxyz[2] = q.y();
  wxyz[3] = q.z();
}

}  // namespace sidestep
