// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// push: a force that a scenario lets act on the robot, as plain data.

#include <Eigen/Core>
#include <array>
#include <numbers>
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

/// Mean force of a push over its largest: its impulse is that times |force_N| duration_s.
constexpr double MeanShare(PushProfile profile) {
  return profile == PushProfile::kConstant ? 1.0 : 2.0 / std::numbers::pi;
}

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
/// Its impulse is MeanShare(profile) |force_N| duration_s, wherever start and end are between two
/// physics steps (push_ticks.h). Two pushes at once add up.
struct Push {
  std::string body;                                  ///< A body or a frame (site) of the robot.
  Eigen::Vector3d force_N{Eigen::Vector3d::Zero()};  ///< In axes of `frame`.
  double start_s{0.0};
  double duration_s{0.0};                            ///< > 0 of a push that was read.
  Eigen::Vector3d point_m{Eigen::Vector3d::Zero()};  ///< In the body's or frame's own axes.
  PushProfile profile{PushProfile::kConstant};       ///< half_sine peaks at force_N.
  PushFrame frame{PushFrame::kWorld};  ///< Of force_N alone; point_m is always the body's.
};

/// Instants of a foot's stride, by name.
enum class PhaseName { kMidSwing, kSwingToStance, kMidStance, kStanceToSwing };

template <>
struct EnumNames<PhaseName> {
  static constexpr std::array<std::pair<PhaseName, std::string_view>, 4> kNames{
      {{PhaseName::kMidSwing, "mid_swing"},
       {PhaseName::kSwingToStance, "swing_to_stance"},
       {PhaseName::kMidStance, "mid_stance"},
       {PhaseName::kStanceToSwing, "stance_to_swing"}}};
};

/// An instant of a foot's stride, which lasts from one lift-off of the foot to its next: a share of
/// it, or a name. The names go by the foot's own touch-down, wherever that is in the stride.
struct StridePhase {
  double share{0.0};              ///< 0 to 1; means nothing if there is a name.
  std::optional<PhaseName> name;  ///< Empty: `share` tells.
};

/// The first foot of a robot is its left one.
enum class PushFoot { kLeft, kRight };

template <>
struct EnumNames<PushFoot> {
  static constexpr std::array<std::pair<PushFoot, std::string_view>, 2> kNames{
      {{PushFoot::kLeft, "left"}, {PushFoot::kRight, "right"}}};
};

/// A push as a file spells it. Its force is `force_N`, or a horizontal one along `direction_rad` of
/// one of three sizes; its start is `start_s`, or a phase of the gait. resolve_pushes.h makes the
/// Push of it.
struct PushEntry {
  Push push;  ///< Its force_N, frame and start_s are final only once resolved.
  std::optional<Eigen::Vector3d> force_N;  ///< Excludes the next four.
  std::optional<double> magnitude_N;       ///< One of these three goes with direction_rad.
  std::optional<double> magnitude_mg;
  std::optional<double> impulse_Nspkg;
  std::optional<double> direction_rad;
  std::optional<double> start_s;  ///< Excludes the next three.
  std::optional<StridePhase> at_phase;
  std::optional<PushFoot> foot;  ///< Goes with at_phase, as the next.
  std::optional<double> after_s;

  template <typename Self, typename Visitor>
  static void VisitFields(Self& self, Visitor&& visit) {
    // Bounds that only catch slips of the pen, such as millimetres for metres.
    constexpr double kMaxForce_N = 1e5;
    constexpr double kMaxForce_mg = 100.0;
    constexpr double kMaxImpulse_Nspkg = 100.0;
    constexpr double kMaxAngle_rad = 7.0;  // a turn and a bit
    constexpr double kMaxTime_s = 1e4;
    visit("body", self.push.body, Required("a body or a frame (site) of the robot"));
    visit("force_N", self.force_N, Range{-kMaxForce_N, kMaxForce_N},
          "the force; this, or direction_rad and one of the next three");
    visit("magnitude_N", self.magnitude_N, Range{0.0, kMaxForce_N},
          "size of a horizontal force along direction_rad");
    visit("magnitude_mg", self.magnitude_mg, Range{0.0, kMaxForce_mg},
          "the same in weights of the plant: mass_kg * 9.81 m/s^2");
    visit("impulse_Nspkg", self.impulse_Nspkg, Range{0.0, kMaxImpulse_Nspkg},
          "the same by the push's impulse over the plant's mass: the speed it would give a free "
          "body");
    visit("direction_rad", self.direction_rad, Range{-kMaxAngle_rad, kMaxAngle_rad},
          "angle about z from the heading of the base: 0 pushes forwards, pi/2 to the left");
    visit("start_s", self.start_s, Range{0.0, kMaxTime_s}, "when it begins; this, or at_phase");
    visit("at_phase", self.at_phase, Range{0.0, 1.0},
          "when it begins, in the gait that the scenario asks for: share of a stride of `foot`, "
          "from its lift-off to its next one, or an instant of it by name");
    visit("foot", self.foot, "whose stride at_phase means; left unless told, the first foot");
    visit("after_s", self.after_s, Range{0.0, kMaxTime_s},
          "at_phase is in the first stride that begins at this time or later; 0 unless told");
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
