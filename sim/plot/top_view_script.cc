// SPDX-License-Identifier: BSD-3-Clause
// The run from above: soles where they stood and where they were to, the CoM's path, the pushes.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <ostream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "sim/palette/palette.h"
#include "sim/plot/plot_script.h"
#include "sim/plot/top_view.h"
#include "sim/process/gnuplot.h"

namespace sidestep::plot {
namespace {

using Eigen::Vector2d;

constexpr double kTopTicX_em = 5.5;  // room that a number wants along x, and along y
constexpr double kTopTicY_em = 2.2;
constexpr double kLeastMove_em = 0.6;  // a shorter arrow would be a speck
constexpr double kAside_em = 0.9;      // of a step's number, where an arrow or a point is

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
    const Vector2d tail = TailOf(mark, view.m_per_em);
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
  script << "set xtics " << NiceStep(kTopTicX_em * view.m_per_em) << "\nset ytics "
         << NiceStep(kTopTicY_em * view.m_per_em) << "\n";
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
