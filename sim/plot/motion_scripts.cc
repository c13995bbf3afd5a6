// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>
#include <string>
#include <vector>

#include "sim/palette/palette.h"
#include "sim/plot/plot_script.h"

namespace sidestep::plot {
namespace {

constexpr double kLeastSolve_ms = 1e-3;  // a logarithm's end for clocks that saw nothing

// One panel: the CoM's position or velocity along an axis.
std::string ComPanel(const PlotData& data, const std::string& quantity, bool has_key) {
  const auto title = [&](const char* text) { return has_key ? text : ""; };
  const auto curve = [&](const std::string& who, const std::string& style, const char* text) {
    return Curve(data, who + quantity, style, title(text));
  };
  std::string script = YAxis(
      data, 3, {"truth" + quantity, "reference" + quantity, "mpc" + quantity, "belief" + quantity});
  script += "plot " + curve("truth", LineStyle(palette::kTruth, kThick), "true") + ", \\\n  " +
            curve("reference", LineStyle(palette::kReference, "linewidth 1.5"), "reference") +
            ", \\\n  " + curve("belief", LineStyle(palette::kBelief), "believed") + ", \\\n  " +
            curve("mpc", LineStyle(palette::kPlanned, kDashed), "planned by the MPC");
  if (has_key) script += ", \\\n  " + PushKey(data);
  return script + "\n";
}

std::string ThreeAxes(const PlotData& data, const std::string& stem, const std::string& unit,
                      bool has_key) {
  std::vector<std::string> curves;
  std::string lines;
  for (std::size_t i = 0; i < kAxes.size(); ++i) {
    curves.push_back(stem + "_" + kAxes[i] + "_" + unit);
    lines += (i == 0 ? "plot " : ", \\\n  ") +
             Curve(data, curves.back(), LineStyle(palette::Axis(i)), has_key ? kAxes[i] : "");
  }
  return YAxis(data, 3, curves, true) + lines;
}

// Whole decades that hold all times and the deadline.
std::string TimeAxis(const PlotData& data) {
  Span span;
  for (const char* curve : {"solve_wall_ms", "solve_cpu_ms"}) {
    if (data.curves.Has(curve)) span.Include(data.curves.YOf(curve));
  }
  if (data.deadline_ms > 0.0) span.Include(data.deadline_ms);
  if (span.is_empty()) span = {0.1, 100.0};
  const double low = std::floor(std::log10(std::max(kLeastSolve_ms, span.min)) + 1e-9);
  const double high = std::ceil(std::log10(std::max(kLeastSolve_ms, span.max)) - 1e-9);
  return "set logscale y 10\nset format y '%g'\nset yrange [" + Number(std::pow(10.0, low)) + ":" +
         Number(std::pow(10.0, std::max(low + 1.0, high))) + "]\nset ytics 10\nset mytics 10\n" +
         "set grid ytics\n";
}

std::string SolvePoints(const PlotData& data, const char* curve, int point_type,
                        const std::string& color, const char* title) {
  if (!data.curves.Has(curve)) return "";
  return ", \\\n  " + data.curves.Macro(curve) + " with points pointtype " +
         std::to_string(point_type) + " pointsize 0.45 linecolor rgb \"" + color + "\" title '" +
         title + "'";
}

}  // namespace

std::string ComScript(const PlotData& data) {
  std::string script = StartPanels(data, "centre of mass", 3, 2);
  for (std::size_t axis = 0; axis < kAxes.size(); ++axis) {
    const bool is_last = axis + 1 == kAxes.size();
    for (const bool is_position : {true, false}) {
      script += is_last ? "set xlabel 'time (s)'\n" : "unset xlabel\n";
      script += "set ylabel '" + std::string(kAxes[axis]) + (is_position ? " (m)'\n" : " (m/s)'\n");
      script += axis > 0 ? "unset title\n"
                         : std::string("set title '") + (is_position ? "position" : "velocity") +
                               "' offset 0,-0.6\n";
      const std::string suffix = std::string("_") + kAxes[axis] + (is_position ? "_m" : "_mps");
      script += ComPanel(data, (is_position ? "_p_WC" : "_v_WC") + suffix, is_last && is_position);
    }
  }
  return script + "unset multiplot\n";
}

std::string MomentumScript(const PlotData& data) {
  std::string script = StartPanels(data, "push, angular momentum about the CoM, tilt", 3, 1);
  script += "set ylabel 'push (N)'\n" + ThreeAxes(data, "push_force_W", "N", false) + "\n";
  script += "set ylabel 'h about C (kg m²/s)'\n" + ThreeAxes(data, "truth_h_C_W", "kgm2ps", true) +
            ", \\\n  keyentry with lines " + LineStyle(palette::kTruth) +
            " title 'tilt of the base', \\\n  " + PushKey(data) + "\n";
  script += "set ylabel 'tilt (rad)'\nset xlabel 'time (s)'\n" +
            YAxis(data, 3, {"truth_tilt_rad"}, true) + "plot " +
            Curve(data, "truth_tilt_rad", LineStyle(palette::kTruth), "") + "\n";
  return script + "unset multiplot\n";
}

std::string SolveScript(const PlotData& data) {
  std::ostringstream script;
  const double right = 1.0 - MarginsOf(data.canvas).left / data.canvas.width_em();
  const bool has_iterations = data.curves.Has("solve_iterations");
  const double most = has_iterations ? data.curves.YOf("solve_iterations").max : 1.0;
  script << StartPanels(data, "MPC solves", 1, 1) << "set rmargin at screen " << right
         << "\nset xlabel 'time (s)'\nset ylabel 'solve time (ms)'\nset y2label 'iterations'\n"
         << "set border 11\n"
         << TimeAxis(data) << "set y2range [0:" << 1.1 * std::max(1.0, most) << "]\nset y2tics "
         << std::max(1.0, NiceStep(most / 8.0)) << " nomirror\n";
  if (data.p99_ms > 0.0) {
    char times[96];
    std::snprintf(times, sizeof times, "p50 %.3g ms, p99 %.3g ms", data.p50_ms, data.p99_ms);
    script << "set title '" << times << "' offset 0,-0.6\n";
  }
  script << "plot NaN notitle";
  if (has_iterations) {
    script << ", \\\n  " << data.curves.Macro("solve_iterations") << " axes x1y2 with steps "
           << LineStyle(palette::kReference, "linewidth 1.0") << " title 'iterations (right axis)'";
  }
  script << SolvePoints(data, "solve_wall_ms", 7, palette::Foot(0), "solve time")
         << SolvePoints(data, "solve_cpu_ms", 6, palette::kTruth, "of the processor");
  if (data.deadline_ms > 0.0) {
    script << ", \\\n  " << data.deadline_ms << " with lines "
           << LineStyle(palette::kLimit, "linewidth 1.4 dashtype (8,4)") << " title 'deadline'";
  }
  script << ", \\\n  " << PushKey(data) << "\nunset multiplot\n";
  return script.str();
}

}  // namespace sidestep::plot
