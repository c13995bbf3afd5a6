// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// decoration: what is drawn beside the robot, as plain data: pushes, ground forces, the CoM's
// trace.
//
// Pure functions from a logged row to shapes in W. Nothing here knows MuJoCo or OpenGL.

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

#include "sim/palette/palette.h"
#include "sim/record/run_reader.h"

namespace sidestep::render {

using Color = Eigen::Vector4f;  ///< Red, green, blue, alpha in 0..1.

/// A colour of the palette, which plots share.
inline Color Painted(const char* hex, float alpha) {
  const std::array<float, 3> channels = palette::Channels(hex);
  return {channels[0], channels[1], channels[2], alpha};
}

inline const Color kPushColor = Painted(palette::kPush, 1.0F);
inline const Color kNominalColor = Painted(palette::kNominal, 0.9F);
inline const Color kComTraceColor = Painted(palette::kTruth, 0.9F);
inline const Color kShadowColor{0.0F, 0.0F, 0.0F, 0.28F};

/// The colour of a foot's adjusted footholds and of the force on it, by its place in the log's list
/// of feet.
Color FootColor(std::size_t foot);

enum class Shape {
  kArrow,  ///< From `from` to its tip `to`, shaft of half width `radius_m`.
  kLine,   ///< A round bar from `from` to `to`.
  kDisc,   ///< A flat round plate on the floor at `from`.
  kSlab,   ///< A flat box on the floor centred at `from`, half extents `half_m`, turned by yaw_rad.
  kBall    ///< At `from`.
};

struct Decoration {
  Shape shape{Shape::kBall};
  Eigen::Vector3d from{Eigen::Vector3d::Zero()};
  Eigen::Vector3d to{Eigen::Vector3d::Zero()};
  Eigen::Vector3d half_m{Eigen::Vector3d::Zero()};
  double radius_m{0.0};
  double yaw_rad{0.0};  ///< About z.
  Color color{Color::Ones()};
  std::string label;  ///< Drawn at `from`; empty for none.
};

/// Sizes that suit a robot: everything drawn scales with its CoM height.
struct DrawScale {
  double com_height_m{0.5};     ///< Of the robot at the log's start.
  double push_m_per_N{0.0};     ///< Arrow length per force; the run's largest push is longest.
  double contact_m_per_N{0.0};  ///< Likewise for the ground's forces.
};

/// The scale for a whole log, so that arrows of one run compare.
DrawScale ScaleFor(const StateLog& log, double com_height_m);

/// The push that acts in `row`: one arrow that points at its point of application from outside,
/// labelled in newtons. Empty while no push acts.
std::vector<Decoration> PushArrow(const StateRow& row, const DrawScale& scale);

/// A thin arrow per foot that bears load, from the ground upwards.
std::vector<Decoration> ContactForceArrows(const StateRow& row, const DrawScale& scale);

/// A round shadow on the floor below the CoM, as of a lamp above: it tells height and place where
/// no shadows are computed.
std::vector<Decoration> GroundShadow(const StateRow& row, const Eigen::Vector3d& p_WC,
                                     const DrawScale& scale);

/// A line through past positions of the CoM, oldest first, fading to the oldest; and the same on
/// the floor, where the robot does not hide it.
std::vector<Decoration> ComTrace(const std::vector<Eigen::Vector3d>& p_WC, const DrawScale& scale);

}  // namespace sidestep::render
