// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// branches: questions to a robot's tree of joints that move, with all of them at zero.
//
// A segment is a link that a joint moves (or the root) with all that is fixed to it, named by it.

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "models/import/posture.h"
#include "models/import/source_robot.h"

namespace sidestep::importer {

/// Limbs nearer than that to the middle have no side.
inline constexpr double kLeastLateral_m = 0.01;

class Branches {
 public:
  /// `robot` must outlive this.
  explicit Branches(const SourceRobot& robot)
      : robot_(robot), zero_(robot, ZeroPosture(robot)), height_m_(FindHeight()) {}

  const SourceJoint& Joint(int joint) const {
    return robot_.joints[static_cast<std::size_t>(joint)];
  }
  const SourceLink& Link(int link) const { return robot_.links[static_cast<std::size_t>(link)]; }
  const Placement& zero() const { return zero_; }
  Eigen::Vector3d Place(int link) const { return zero_.X_WL(link).translation(); }

  /// Between the lowest and the highest link's origin (m), above 0.
  double Height() const { return height_m_; }

  /// Joints that move from `ancestor` down to `link`.
  std::vector<int> Chain(int ancestor, int link) const;

  /// The lowest link above (or equal to) both.
  int CommonAncestor(int a, int b) const;

  /// Lowest point known of a link and what is fixed to it: origins and CoM (m).
  double Lowest(int link) const;

  /// Segments below which nothing moves, the lowest first.
  std::vector<int> Ends() const;

  /// Whether what hangs on the two weighs about the same and begins at about the same height.
  bool MirrorEachOther(int link_a, int link_b) const;

  /// The segment that `link` belongs to.
  int Segment(int link) const;

  /// kg, of a segment alone.
  double SegmentMass_kg(int segment) const;

  /// The joint that carries more than half of what moves on a segment, if one does.
  std::optional<int> Next(int segment) const;

 private:
  double FindHeight() const;

  const SourceRobot& robot_;
  Placement zero_;
  double height_m_;
};

}  // namespace sidestep::importer
