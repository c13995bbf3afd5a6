// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <sstream>

#include "sim/plot/plot_script.h"

namespace sidestep::plot {
namespace {

// One panel: the CoM's position or velocity along an axis.
std::string ComPanel(const PlotData& data, const std::string& quantity, const std::string& unit,
                     const std::string& axis, bool has_key) {
  const auto column = [&](const std::string& who) {
    return who + "_" + quantity + "_" + axis + "_" + unit;
  };
  const auto title = [&](const char* text) { return has_key ? text : ""; };
  std::string script = "plot ";
  script += Curve(column("reference"), LineStyle(kReferenceColor), title("reference")) + ", \\\n  ";
  script += Curve(column("mpc"), LineStyle(kMpcColor, "linewidth 1.1 dashtype (6,3)"),
                  title("planned by the MPC")) +
            ", \\\n  ";
  script += Curve(column("belief"), LineStyle("#CC79A7", "linewidth 1.1 dashtype (2,2)"),
                  title("believed")) +
            ", \\\n  ";
  script += Curve(column("truth"), LineStyle(kTruthColor), title("true"));
  if (has_key) script += ", \\\n  " + PushKey(data);
  return script + "\n";
}

}  // namespace

std::string ComScript(const PlotData& data) {
  std::string script = StartPanels(data, "centre of mass", 3, 2);
  for (std::size_t axis = 0; axis < kAxes.size(); ++axis) {
    const bool is_last = axis + 1 == kAxes.size();
    for (const bool is_position : {true, false}) {
      script += is_last ? "set xlabel 'time (s)'\n" : "unset xlabel\n";
      script += "set ylabel '" + std::string(kAxes[axis]) + (is_position ? " (m)'" : " (m/s)'") +
                " offset 0.5\n";
      script += axis > 0 ? "unset title\n"
                         : std::string("set title '") + (is_position ? "position" : "velocity") +
                               "' offset 0,-0.6\n";
      script += is_position ? ComPanel(data, "p_WC", "m", kAxes[axis], is_last)
                            : ComPanel(data, "v_WC", "mps", kAxes[axis], false);
    }
  }
  return script + "unset multiplot\n";
}

std::string MomentumScript(const PlotData& data) {
  static const std::array<std::string, 3> kColors{"#0072B2", "#D55E00", "#009E73"};
  std::string script = StartPanels(data, "push, angular momentum about the CoM, tilt", 3, 1);
  const auto three = [&](const std::string& stem, const std::string& unit, bool has_key) {
    std::string lines;
    for (std::size_t i = 0; i < 3; ++i) {
      lines +=
          (i == 0 ? "plot " : ", \\\n  ") +
          Curve(stem + "_" + kAxes[i] + "_" + unit, LineStyle(kColors[i]), has_key ? kAxes[i] : "");
    }
    return lines;
  };
  script += "set ylabel 'push (N)'\n" + three("push_force_W", "N", false) + "\n";
  script += "set ylabel 'h about C (kg m²/s)'\n" + three("truth_h_C_W", "kgm2ps", true) +
            ", \\\n  keyentry with lines " + LineStyle("#CC79A7") +
            " title 'tilt of the base', \\\n  " + PushKey(data) + "\n";
  script += "set ylabel 'tilt (rad)'\nset xlabel 'time (s)'\nset yrange [0:*]\nplot " +
            Curve("truth_tilt_rad", LineStyle("#CC79A7"), "") + "\n";
  return script + "unset multiplot\n";
}

std::string SolveScript(const PlotData& data) {
  std::ostringstream script;
  script << StartPanels(data, "MPC solves", 1, 1) << "set rmargin at screen 0.92\n"
         << "set xlabel 'time (s)'\nset ylabel 'solve time (ms)'\nset y2label 'iterations'\n"
         << "set ytics nomirror\nset y2tics nomirror\nset border 11\n"
         << "set yrange [0:*]\nset offsets 0, 0, graph 0.06, 0\nset y2range [0:"
         << (data.has_solves ? "*" : "1") << "]\n";
  if (data.p99_ms > 0.0) {
    script << "set title 'p50 " << data.p50_ms << " ms, p99 " << data.p99_ms
           << " ms' offset 0,-0.6\n";
  }
  // The zero line keeps the axis defined for a run without a solve.
  script << "plot 0 with lines linecolor rgb \"#B0B0B0\" linewidth 0.5 notitle";
  if (data.has_solves) {
    script << ", \\\n  '../mpc.csv' using \"time_s\":\"iterations\" axes x1y2 with steps "
           << LineStyle(kReferenceColor, "linewidth 1.0") << " title 'iterations (right axis)'"
           << ", \\\n  '../mpc.csv' using \"time_s\":\"wall_ms\" with points pointtype 7 "
           << "pointsize 0.45 linecolor rgb \"" << kTruthColor << "\" title 'solve time'";
    if (data.has_cpu_times) {
      script << ", \\\n  '../mpc.csv' using \"time_s\":\"cpu_ms\" with points pointtype 6 "
             << "pointsize 0.45 linecolor rgb \"" << kMpcColor << "\" title 'of the processor'";
    }
  }
  if (data.deadline_ms > 0.0) {
    script << ", \\\n  " << data.deadline_ms << " with lines "
           << LineStyle("#D55E00", "linewidth 1.4 dashtype (8,4)") << " title 'deadline'";
  }
  script << ", \\\n  " << PushKey(data) << "\nunset multiplot\n";
  return script.str();
}

}  // namespace sidestep::plot
