// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// push: a force that a scenario lets act on the robot, as plain data.

#include <Eigen/Core>
#include <array>
#include <string>
#include <string_view>
#include <utility>

#include "controller/types/field.h"

namespace sidestep {

enum class PushProfile { kConstant, kHalfSine };

template <>
struct EnumNames<PushProfile> {
  static constexpr std::array<std::pair<PushProfile, std::string_view>, 2> kNames{
      {{PushProfile::kConstant, "constant"}, {PushProfile::kHalfSine, "half_sine"}}};
};

enum class PushFrame {
  kWorld,    ///< Axes of W.
  kHeading,  ///< W turned about z by the base's yaw when the push starts.
  kBody      ///< Axes of the pushed body or frame, turning with it.
};

template <>
struct EnumNames<PushFrame> {
  static constexpr std::array<std::pair<PushFrame, std::string_view>, 3> kNames{
      {{PushFrame::kWorld, "world"}, {PushFrame::kHeading, "heading"}, {PushFrame::kBody, "body"}}};
};

/// A scripted force at a point of a body. The file gives `force_N`, or `magnitude_N` with
/// `direction_rad` (about z from x, heading frame); either way it ends up here as force_N.
struct Push {
  std::string body;  ///< A body or a frame (site) of the robot.
  Eigen::Vector3d force_N{Eigen::Vector3d::Zero()};
  double start_s{0.0};
  double duration_s{0.0};
  Eigen::Vector3d point_m{Eigen::Vector3d::Zero()};  ///< In the body's or frame's own axes.
  PushProfile profile{PushProfile::kConstant};       ///< half_sine peaks at force_N.
  PushFrame frame{PushFrame::kWorld};
};

}  // namespace sidestep
