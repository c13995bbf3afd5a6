// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// top_view: which part of the ground a run is seen on from above, how large, and where things are
// on it. Points in W, x and y (m).

#include <Eigen/Core>
#include <vector>

#include "sim/plot/plot_data.h"

namespace sidestep::plot {

/// The ground that the plot shows, in rows one after the other.
struct View {
  Span x;
  Span y;
  double m_per_em{0.0};
  int rows{1};  ///< Each shows length_m of x.
  double length_m{0.0};
};

/// A view that holds all that is drawn: one scale for both axes, in as many rows as draw a long
/// walk largest. Arrows of pushes are as long as their words ask.
View FittedView(const PlotData& data);

/// A point of a sole that lies at p_WF, turned by its yaw.
Eigen::Vector2d Placed(const Eigen::Vector2d& p_F, const Eigen::Vector3d& p_WF, double yaw_rad);

/// Where the foot stood, or, if it never landed, where it was to.
const Eigen::Vector3d& PlaceOf(const Footstep& step);

/// Corners of the box that the adjustment must keep, in F; none if the controller told none.
std::vector<Eigen::Vector2d> BoxOf(const Footstep& step);

/// Tail of the arrow of a push, whose head is at the CoM. Precondition: its force is not zero.
Eigen::Vector2d TailOf(const PushMark& mark, double m_per_em);

/// Beside that tail, where its newtons are written.
Eigen::Vector2d NewtonsAt(const PushMark& mark, double m_per_em);

}  // namespace sidestep::plot
