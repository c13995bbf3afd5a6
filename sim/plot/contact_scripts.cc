// SPDX-License-Identifier: BSD-3-Clause
// Plots of the feet over time: what the ground does to them, and where the controller puts them.
#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "sim/palette/palette.h"
#include "sim/plot/plot_script.h"
#include "sim/process/gnuplot.h"

namespace sidestep::plot {
namespace {

// What the MPC allowed a foot from its lift-off to its next one, and what it did at touch-down.
struct StepTables {
  std::string allowed;  // start, end, lowest, highest, as boxxyerror takes them
  std::string taken;    // time, adjustment
  Span span;
};

StepTables TablesOf(const PlotData& data, std::size_t foot, int axis) {
  StepTables tables;
  std::ostringstream allowed, taken;
  for (const PlottedStep& step : data.steps) {
    if (step.foot != foot) continue;
    const double lower = step.step.box_lower_m[axis], upper = step.step.box_upper_m[axis];
    if (std::isfinite(lower) && std::isfinite(upper)) {
      const double from_s = std::max(step.lift_s, data.start_s);
      const double to_s = std::min(step.step.end_s, data.end_s);
      if (to_s > from_s) {
        allowed << from_s << " " << lower << " " << from_s << " " << to_s << " " << lower << " "
                << upper << "\n";
        tables.span.Include(lower);
        tables.span.Include(upper);
      }
    }
    const double moved = step.step.adjusted_p_WF[axis] - step.step.nominal_p_WF[axis];
    if (!std::isfinite(moved) || step.step.start_s < data.start_s) continue;
    if (step.step.start_s > data.end_s) continue;
    taken << step.step.start_s << " " << moved << "\n";
    tables.span.Include(moved);
  }
  tables.allowed = allowed.str();
  tables.taken = taken.str();
  return tables;
}

std::string AdjustmentPanel(const PlotData& data, int axis, bool has_key) {
  std::string blocks, bands, lines;
  Span span;
  span.Include(0.0);
  for (std::size_t i = 0; i < data.feet.size(); ++i) {
    const StepTables tables = TablesOf(data, i, axis);
    const std::string number = std::to_string(i) + kAxes[static_cast<std::size_t>(axis)];
    const std::string curve =
        "adjustment_" + data.feet[i] + "_" + kAxes[static_cast<std::size_t>(axis)] + "_m";
    span.Include(tables.span);
    span.Include(data.curves.YOf(curve));
    blocks += DataBlock("allowed" + number, tables.allowed, 6) +
              DataBlock("taken" + number, tables.taken, 2);
    const auto title = [&](const char* what) {
      return has_key ? "title " + GnuplotText(data.feet[i] + what) : std::string("notitle");
    };
    const std::string color = std::string("rgb \"") + palette::Foot(i) + "\"";
    bands += (i == 0 ? "plot $allowed" : ", \\\n  $allowed") + number +
             " using 1:2:3:4:5:6 with boxxyerror fillcolor " + color +
             " fillstyle transparent solid 0.14 noborder " + title(", allowed");
    lines += ", \\\n  " +
             Curve(data, curve, LineStyle(palette::Foot(i), "linewidth 1.6"),
                   has_key ? data.feet[i] + ", planned" : "") +
             ", \\\n  $taken" + number + " using 1:2 with points pointtype 7 pointsize 0.8 " +
             "linecolor " + color + " " + title(", taken");
  }
  const std::string zero = (bands.empty() ? "plot " : ", \\\n  ") + ZeroLine();
  return blocks + AxisLines("y", span, PanelSize_em(data.canvas, 2, 1).y()) + bands + zero + lines +
         (has_key ? ", \\\n  " + PushKey(data) : "") + "\n";
}

}  // namespace

std::string ContactForceScript(const PlotData& data) {
  std::string script = StartPanels(data, "force of the ground on each foot", 3, 1);
  for (const char* axis : kAxes) {
    const bool has_key = *axis == 'z';
    std::vector<std::string> curves;
    std::string truths, plans;
    for (std::size_t i = 0; i < data.feet.size(); ++i) {
      const std::string suffix = data.feet[i] + "_" + axis + "_N";
      curves.insert(curves.end(), {"truth_f_F_W_" + suffix, "mpc_f_F_W_" + suffix});
      truths += ", \\\n  " + Curve(data, curves[2 * i], FaintStyle(palette::Foot(i), "linewidth 2"),
                                   has_key ? data.feet[i] + ", true" : "");
      plans += ", \\\n  " + Curve(data, curves[2 * i + 1], LineStyle(palette::Foot(i), kDashed),
                                  has_key ? data.feet[i] + ", MPC" : "");
    }
    script += std::string("set ylabel '") + axis + " (N)'\n";
    if (has_key) script += "set xlabel 'time (s)'\n";
    script += YAxis(data, 3, curves, true) + "plot " + ZeroLine() + truths + plans;
    if (has_key) script += ", \\\n  " + PushKey(data);
    script += "\n";
  }
  return script + "unset multiplot\n";
}

std::string AdjustmentScript(const PlotData& data) {
  return StartPanels(data, "footholds moved from their nominal place", 2, 1) +
         "set ylabel 'x, forward (m)'\n" + AdjustmentPanel(data, 0, false) +
         "set ylabel 'y, left (m)'\nset xlabel 'time (s)'\n" + AdjustmentPanel(data, 1, true) +
         "unset multiplot\n";
}

}  // namespace sidestep::plot
