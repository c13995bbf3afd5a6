// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// push: a force that a scenario lets act on the robot, as plain data.

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "controller/types/field.h"

namespace sidestep {

/// Course of the force over the push's time; sim/world/pushes.h has the formula.
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

/// A scripted force at a point of a body.
/// Its impulse is |force_N| duration_s of a constant one, 2/pi of that of a half sine. start_s and
/// duration_s are rounded to ticks where the force acts. Two pushes at once add up.
struct Push {
  std::string body;                                  ///< A body or a frame (site) of the robot.
  Eigen::Vector3d force_N{Eigen::Vector3d::Zero()};  ///< In axes of `frame`.
  double start_s{0.0};
  double duration_s{0.0};                            ///< > 0 of a push that was read.
  Eigen::Vector3d point_m{Eigen::Vector3d::Zero()};  ///< In the body's or frame's own axes.
  PushProfile profile{PushProfile::kConstant};       ///< half_sine peaks at force_N.
  PushFrame frame{PushFrame::kWorld};  ///< Of force_N alone; point_m is always the body's.
};

/// A push as a file spells it: `force_N`, or `magnitude_N` with `direction_rad`; read_sections
/// turns the latter into a force_N in the heading frame.
struct PushEntry {
  Push push;  ///< Its force_N and frame are final only after read_sections.
  std::optional<Eigen::Vector3d> force_N;  ///< Excludes the two below.
  std::optional<double> magnitude_N;       ///< Goes with direction_rad.
  std::optional<double> direction_rad;

  template <typename Self, typename Visitor>
  static void VisitFields(Self& self, Visitor&& visit) {
    // Bounds that only catch slips of the pen, such as millimetres for metres.
    constexpr double kMaxForce_N = 1e5;
    constexpr double kMaxAngle_rad = 7.0;  // a turn and a bit
    constexpr double kMaxTime_s = 1e4;
    visit("body", self.push.body, Required("a body or a frame (site) of the robot"));
    visit("force_N", self.force_N, Range{-kMaxForce_N, kMaxForce_N},
          "the force; this, or magnitude_N and direction_rad");
    visit("magnitude_N", self.magnitude_N, Range{0.0, kMaxForce_N},
          "size of a horizontal force along direction_rad");
    visit("direction_rad", self.direction_rad, Range{-kMaxAngle_rad, kMaxAngle_rad},
          "angle about z from the heading of the base: 0 pushes forwards, pi/2 to the left");
    visit("start_s", self.push.start_s, Range{0.0, kMaxTime_s}, Required("when it begins"));
    visit("duration_s", self.push.duration_s, Range{0.0, kMaxTime_s, true},
          Required("how long it lasts"));
    visit("point_m", self.push.point_m, Range{-10.0, 10.0},
          "where it acts, in the axes of the body or frame");
    visit("profile", self.push.profile,
          "constant, or half_sine: rises to the force and falls again");
    visit("frame", self.push.frame,
          "axes of force_N: world; heading: world turned by the yaw of the base when the push "
          "starts; body: the axes of the pushed body, turning with it");
  }
};

}  // namespace sidestep
