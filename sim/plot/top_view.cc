// SPDX-License-Identifier: BSD-3-Clause
#include "sim/plot/top_view.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "sim/plot/plot_script.h"

namespace sidestep::plot {
namespace {

using Eigen::Vector2d;

constexpr double kPushArrow_em = 4.0;
constexpr double kRoom_em = 1.6;    // around what is drawn, for its numbers
constexpr int kMostViewRows = 4;    // that a long walk is broken into
constexpr double kWorthARow = 0.8;  // another row must draw it this much larger
constexpr double kFinest_m_per_em = 1e-3;

void IncludePoint(const Vector2d& point, View* view) {
  view->x.Include(point.x());
  view->y.Include(point.y());
}

// All that is drawn but arrows and words, whose size on the ground follows from the scale.
View ExtentOf(const PlotData& data) {
  View view;
  for (const char* path : {"truth_path", "reference_path"}) {
    view.x.Include(data.curves.XOf(path));
    view.y.Include(data.curves.YOf(path));
  }
  for (const PlottedStep& plotted : data.steps) {
    const Footstep& step = plotted.step;
    std::vector<Vector2d> sole = data.soles[plotted.foot];
    if (sole.empty()) sole.emplace_back(Vector2d::Zero());
    for (const Vector2d& corner : sole) {
      IncludePoint(Placed(corner, PlaceOf(step), step.yaw_rad), &view);
      IncludePoint(Placed(corner, step.nominal_p_WF, step.yaw_rad), &view);
    }
    if (!plotted.is_far_moved) continue;
    for (const Vector2d& corner : BoxOf(step)) {
      IncludePoint(Placed(corner, step.nominal_p_WF, step.yaw_rad), &view);
    }
  }
  return view;
}

// Ems on the ground if the extent is broken into that many rows.
double Scale_m_per_em(const View& extent, const Canvas& canvas, int rows) {
  const Vector2d panel = PanelSize_em(canvas, rows, 1);
  const double width = extent.x.length() / rows / std::max(1.0, panel.x() - 2 * kRoom_em);
  const double height = extent.y.length() / std::max(1.0, panel.y() - 2 * kRoom_em);
  return std::max({width, height, kFinest_m_per_em});
}

}  // namespace

Vector2d Placed(const Vector2d& p_F, const Eigen::Vector3d& p_WF, double yaw_rad) {
  return p_WF.head<2>() + Eigen::Rotation2Dd(yaw_rad) * p_F;
}

const Eigen::Vector3d& PlaceOf(const Footstep& step) {
  return step.realised_p_WF ? *step.realised_p_WF : step.adjusted_p_WF;
}

std::vector<Vector2d> BoxOf(const Footstep& step) {
  const Vector2d &low = step.box_lower_m, &high = step.box_upper_m;
  if (!low.allFinite() || !high.allFinite()) return {};
  return {low, {high.x(), low.y()}, high, {low.x(), high.y()}};
}

Vector2d TailOf(const PushMark& mark, double m_per_em) {
  const Vector2d force(mark.force_x_N, mark.force_y_N);
  return Vector2d(mark.x_m, mark.y_m) - kPushArrow_em * m_per_em * force.normalized();
}

View FittedView(const PlotData& data) {
  View view = ExtentOf(data);
  for (int rows = 2; rows <= kMostViewRows; ++rows) {
    const bool is_larger = Scale_m_per_em(view, data.canvas, rows) <
                           kWorthARow * Scale_m_per_em(view, data.canvas, view.rows);
    if (is_larger) view.rows = rows;
  }
  const Vector2d panel = PanelSize_em(data.canvas, view.rows, 1);
  for (int pass = 0; pass < 2; ++pass) {  // the arrows' room changes the scale a little
    view.m_per_em = Scale_m_per_em(view, data.canvas, view.rows);
    for (const PushMark& mark : data.push_marks) {
      if (std::hypot(mark.force_x_N, mark.force_y_N) > 0.0) {
        IncludePoint(TailOf(mark, view.m_per_em), &view);
      }
    }
  }
  const Vector2d size_m = view.m_per_em * panel;
  const double y = 0.5 * (view.y.min + view.y.max);
  const double spare_m = view.rows * size_m.x() - view.x.length();
  view.length_m = size_m.x();
  view.x.min -= view.rows > 1 ? std::min(0.5 * spare_m, kRoom_em * view.m_per_em) : 0.5 * spare_m;
  view.x.max = view.x.min + view.rows * size_m.x();
  view.y = {y - 0.5 * size_m.y(), y + 0.5 * size_m.y()};
  return view;
}

Vector2d NewtonsAt(const PushMark& mark, double m_per_em) {
  const Vector2d tail = TailOf(mark, m_per_em);
  Vector2d aside = Vector2d(-mark.force_y_N, mark.force_x_N).normalized();
  if (aside.y() < -1e-6) aside = -aside;
  return tail + m_per_em * (0.9 + 0.8 * std::abs(aside.x())) * aside;
}

}  // namespace sidestep::plot
