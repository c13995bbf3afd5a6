// SPDX-License-Identifier: BSD-3-Clause
// The run from above: soles where they stood and where they were to, the CoM's path, the pushes.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <sstream>

#include "sim/palette/palette.h"
#include "sim/plot/plot_script.h"
#include "sim/process/gnuplot.h"

namespace sidestep::plot {
namespace {

using Eigen::Vector2d;

constexpr double kPushArrow_em = 4.0;
constexpr double kLeastMove_em = 0.6;  // a shorter arrow would be a speck
constexpr double kAside_em = 0.9;      // of a step's number, where an arrow or a point is
constexpr double kRoom_em = 1.6;       // around what is drawn, for its numbers
constexpr int kMostViewRows = 4;       // that a long walk is broken into
constexpr double kWorthARow = 0.8;     // another row must draw it this much larger
constexpr double kFinest_m_per_em = 1e-3;

// The part of the ground that a row of the plot shows, and its scale.
struct View {
  Span x;
  Span y;
  double m_per_em{0.0};
  int rows{1};  ///< Each shows length_m of x, one after the other.
  double length_m{0.0};
};

Vector2d Placed(const Vector2d& p_F, const Eigen::Vector3d& p_WF, double yaw_rad) {
  return p_WF.head<2>() + Eigen::Rotation2Dd(yaw_rad) * p_F;
}

// Where the foot stood, or, if it never landed, where it was to.
const Eigen::Vector3d& PlaceOf(const Footstep& step) {
  return step.realised_p_WF ? *step.realised_p_WF : step.adjusted_p_WF;
}

// A closed line through points of F, as a table's rows; a point foot has no outline.
std::string Outline(const std::vector<Vector2d>& points_F, const Eigen::Vector3d& p_WF,
                    double yaw_rad) {
  std::ostringstream rows;
  if (points_F.size() < 2) return {};
  for (std::size_t i = 0; i <= points_F.size(); ++i) {
    const Vector2d p = Placed(points_F[i % points_F.size()], p_WF, yaw_rad);
    rows << p.x() << " " << p.y() << "\n";
  }
  return rows.str() + "\n";
}

std::vector<Vector2d> BoxOf(const Footstep& step) {
  const Vector2d &low = step.box_lower_m, &high = step.box_upper_m;
  if (!low.allFinite() || !high.allFinite()) return {};
  return {low, {high.x(), low.y()}, high, {low.x(), high.y()}};
}

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

Vector2d TailOf(const PushMark& mark, double length_m) {
  const Vector2d force(mark.force_x_N, mark.force_y_N);
  return Vector2d(mark.x_m, mark.y_m) - length_m * force.normalized();
}

// Ems on the ground if the extent is broken into that many rows.
double Scale_m_per_em(const View& extent, const Canvas& canvas, int rows) {
  const Vector2d panel = PanelSize_em(canvas, rows, 1);
  const double width = extent.x.length() / rows / std::max(1.0, panel.x() - 2 * kRoom_em);
  const double height = extent.y.length() / std::max(1.0, panel.y() - 2 * kRoom_em);
  return std::max({width, height, kFinest_m_per_em});
}

// One scale for both axes, with as many rows as draw it largest; arrows are as long as words ask.
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
        IncludePoint(TailOf(mark, kPushArrow_em * view.m_per_em), &view);
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

// Beside the tail of a push's arrow.
Vector2d NewtonsAt(const PushMark& mark, double m_per_em) {
  const Vector2d tail = TailOf(mark, kPushArrow_em * m_per_em);
  Vector2d aside = Vector2d(-mark.force_y_N, mark.force_x_N).normalized();
  if (aside.y() < -1e-6) aside = -aside;
  return tail + m_per_em * (0.9 + 0.8 * std::abs(aside.x())) * aside;
}

// Words at places, of which none covers another.
class Labels {
 public:
  explicit Labels(double m_per_em) : m_per_em_(m_per_em) {}

  /// Whether words of that length have room there; if so, they take it.
  bool Take(const Vector2d& at, std::size_t letters) {
    const Vector2d half_m = m_per_em_ * Vector2d(0.35 * static_cast<double>(letters) + 0.1, 0.6);
    for (const auto& [other, other_half_m] : taken_) {
      const Vector2d apart = (at - other).cwiseAbs() - half_m - other_half_m;
      if (apart.x() < 0.0 && apart.y() < 0.0) return false;
    }
    taken_.emplace_back(at, half_m);
    return true;
  }

 private:
  double m_per_em_;
  std::vector<std::pair<Vector2d, Vector2d>> taken_;
};

bool IsIn(const Span& span, double value) { return value >= span.min && value <= span.max; }

// An arrow into the CoM for each push, with its newtons at the tail; pushes alike have one label.
void AddPushArrows(const PlotData& data, const View& view, const Span& x, Labels* labels,
                   std::ostream& script) {
  for (const PushMark& mark : data.push_marks) {
    const double force_N = std::hypot(mark.force_x_N, mark.force_y_N);
    if (!(force_N > 0.0) || !IsIn(x, mark.x_m)) continue;
    const Vector2d tail = TailOf(mark, kPushArrow_em * view.m_per_em);
    const Vector2d at = NewtonsAt(mark, view.m_per_em);
    script << "set arrow from " << tail.x() << ", " << tail.y() << " to " << mark.x_m << ", "
           << mark.y_m << " front head size screen 0.012,22 filled linewidth 2 linecolor rgb \""
           << palette::kPush << "\"\n";
    const std::string newtons = std::to_string(static_cast<int>(std::lround(force_N))) + " N";
    if (!labels->Take(at, newtons.size())) continue;
    script << "set label '" << newtons << "' at " << at.x() << ", " << at.y() << " front center\n";
  }
}

// A number at each step that has room for it, those that were moved farthest first.
void AddStepNumbers(const PlotData& data, const Span& x, double m_per_em, Labels* labels,
                    std::ostream& script) {
  std::vector<const PlottedStep*> steps;
  for (const PlottedStep& step : data.steps) {
    if (step.number > 0) steps.push_back(&step);
  }
  std::stable_sort(steps.begin(), steps.end(),
                   [](const auto* a, const auto* b) { return a->is_far_moved > b->is_far_moved; });
  for (const PlottedStep* plotted : steps) {
    Vector2d middle = Vector2d::Zero();
    const std::vector<Vector2d>& sole = data.soles[plotted->foot];
    for (const Vector2d& corner : sole) middle += corner / static_cast<double>(sole.size());
    const Footstep& step = plotted->step;
    const bool has_arrow =
        (step.adjusted_p_WF - step.nominal_p_WF).head<2>().norm() > kLeastMove_em * m_per_em;
    const bool is_beside = sole.size() < 3 || has_arrow;
    const Vector2d at = Placed(middle, PlaceOf(step), step.yaw_rad) +
                        Vector2d::Constant(is_beside ? kAside_em * m_per_em : 0.0);
    const std::string number = std::to_string(plotted->number);
    if (!IsIn(x, at.x()) || !labels->Take(at, number.size())) continue;
    script << "set label '" << number << "' at " << at.x() << ", " << at.y() << " front center\n";
  }
}

// What the curves draw, one table of each kind a foot.
std::string Tables(const PlotData& data, double m_per_em) {
  std::string script;
  for (std::size_t i = 0; i < data.feet.size(); ++i) {
    std::string stood, nominal, allowed;
    std::ostringstream moves, points;
    for (const PlottedStep& plotted : data.steps) {
      if (plotted.foot != i) continue;
      const Footstep& step = plotted.step;
      const Eigen::Vector3d& p_WF = PlaceOf(step);
      stood += Outline(data.soles[i], p_WF, step.yaw_rad);
      nominal += Outline(data.soles[i], step.nominal_p_WF, step.yaw_rad);
      if (plotted.is_far_moved) allowed += Outline(BoxOf(step), step.nominal_p_WF, step.yaw_rad);
      const Eigen::Vector3d moved = step.adjusted_p_WF - step.nominal_p_WF;
      points << p_WF.x() << " " << p_WF.y() << " " << step.nominal_p_WF.x() << " "
             << step.nominal_p_WF.y() << "\n";
      if (moved.head<2>().norm() > kLeastMove_em * m_per_em) {
        moves << step.nominal_p_WF.x() << " " << step.nominal_p_WF.y() << " " << moved.x() << " "
              << moved.y() << "\n";
      }
    }
    const std::string number = std::to_string(i);
    script += DataBlock("stood" + number, stood, 2) + DataBlock("nominal" + number, nominal, 2) +
              DataBlock("allowed" + number, allowed, 2) +
              DataBlock("moves" + number, moves.str(), 4) +
              DataBlock("points" + number, points.str(), 4);
  }
  return script;
}

std::string FootCurves(const PlotData& data, std::size_t foot, bool has_key) {
  const std::string number = std::to_string(foot);
  const std::string color = std::string("rgb \"") + palette::Foot(foot) + "\"";
  const std::string grey = std::string("rgb \"") + palette::kNominal + "\"";
  const std::string title =
      has_key ? "title " + GnuplotText(data.feet[foot] + ", stood") : std::string("notitle");
  std::string script = "$allowed" + number + " using 1:2 with lines linewidth 0.6 linecolor " +
                       color + " dashtype (3,3) notitle, \\\n  ";
  if (data.soles[foot].size() < 2) {
    return script + "$points" + number + " using 3:4 with points pointtype 6 pointsize 1.2 " +
           "linewidth 1.2 linecolor " + grey + " notitle, \\\n  $moves" + number +
           " using 1:2:3:4 with vectors head size screen 0.006,25 filled linewidth 1 linecolor " +
           color + " notitle, \\\n  $points" + number +
           " using 1:2 with points pointtype 7 pointsize 0.8 linecolor " + color + " " + title;
  }
  return script + "$stood" + number + " using 1:2 with filledcurves closed fillcolor " + color +
         " fillstyle transparent solid 0.22 noborder " + title + ", \\\n  $stood" + number +
         " using 1:2 with lines linewidth 1.2 linecolor " + color + " notitle, \\\n  $nominal" +
         number + " using 1:2 with lines linewidth 1 dashtype (4,3) linecolor " + grey +
         " notitle, \\\n  $moves" + number +
         " using 1:2:3:4 with vectors head size screen 0.006,25 filled linewidth 1.4 linecolor " +
         color + " notitle";
}

std::string Curves(const PlotData& data, bool has_key) {
  std::string script;
  for (std::size_t i = 0; i < data.feet.size(); ++i) {
    script += (i == 0 ? "plot " : ", \\\n  ") + FootCurves(data, i, has_key);
  }
  script += (script.empty() ? "plot " : ", \\\n  ") +
            Curve(data, "truth_path", LineStyle(palette::kTruth, "linewidth 2.6"),
                  has_key ? "CoM, true" : "") +
            ", \\\n  " +
            Curve(data, "reference_path", LineStyle(palette::kReference, "linewidth 1.3"),
                  has_key ? "CoM, reference" : "");
  if (!has_key) return script + "\n";
  const std::string grey = LineStyle(palette::kNominal, "");
  const bool has_outlines = std::any_of(data.soles.begin(), data.soles.end(),
                                        [](const auto& sole) { return sole.size() > 1; });
  const std::string nominal =
      has_outlines ? "lines " + grey + "linewidth 1 dashtype (4,3)" : "points pointtype 6 " + grey;
  return script + ", \\\n  keyentry with " + nominal +
         " title 'nominal', \\\n  keyentry with vectors filled head " + grey +
         "title 'moved', \\\n  keyentry with lines " + grey +
         "linewidth 0.6 dashtype (3,3) title 'allowed', \\\n  " + PushKey(data) + "\n";
}

}  // namespace

std::string TopViewScript(const PlotData& data) {
  const View view = FittedView(data);
  std::ostringstream script;
  script << StartMultiplot(data, "footsteps and centre of mass from above", view.rows, 1)
         << "set size ratio -1\nset ylabel 'y, left (m)'\n"
         << Tables(data, view.m_per_em) << "set yrange [" << view.y.min << ":" << view.y.max
         << "]\n";
  const double step_m = NiceStep(5.5 * view.m_per_em);
  script << "set xtics " << step_m << "\nset ytics " << NiceStep(2.2 * view.m_per_em) << "\n";
  Labels labels(view.m_per_em);
  for (int row = 0; row < view.rows; ++row) {
    const Span x{view.x.min + row * view.length_m, view.x.min + (row + 1) * view.length_m};
    script << "unset label\nunset arrow\nset xrange [" << x.min << ":" << x.max << "]\n";
    AddPushArrows(data, view, x, &labels, script);
    AddStepNumbers(data, x, view.m_per_em, &labels, script);
    const bool is_last = row + 1 == view.rows;
    if (is_last) script << "set xlabel 'x, forward (m)'\n";
    script << Curves(data, is_last);
  }
  return script.str() + "unset multiplot\n";
}

}  // namespace sidestep::plot
