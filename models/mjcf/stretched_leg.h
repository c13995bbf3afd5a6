// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// stretched_leg: where a leg begins and ends, and how long it is at most.

#include <Eigen/Core>
#include <optional>

#include "models/mjcf/mj_state.h"

namespace sidestep {

/// Of the joints between base and foot the hip is the first one's anchor. The ankle is the last
/// one's, if the foot is a sole that stays flat; else the foot's frame.
struct StretchedLeg {
  Eigen::Vector3d p_WHip{Eigen::Vector3d::Zero()};    ///< m, at the state given.
  Eigen::Vector3d p_WAnkle{Eigen::Vector3d::Zero()};  ///< m, likewise.
  double length_m{0.0};  ///< Hip to ankle, the largest that the joints' ranges allow.
};

/// The leg from body `base` to the foot of site `site`. `home` must have been through
/// mj_kinematics. The length is found by one joint after the other, each searched over its range:
/// exact where a single joint, the knee, decides. Nothing, if fewer than two joints part base and
/// foot or if a slide without a range does.
std::optional<StretchedLeg> FindStretchedLeg(const MjState& home, int base, int site, bool is_sole);

}  // namespace sidestep
