// SPDX-License-Identifier: BSD-3-Clause
// Plots of what acts on the body: the push as it is and as it is felt, and how the feet stand.
#include <string>
#include <vector>

#include "sim/palette/palette.h"
#include "sim/plot/plot_script.h"
#include "sim/process/gnuplot.h"

namespace sidestep::plot {
namespace {

std::string TrueAndFelt(const PlotData& data, const std::string& column, bool has_key) {
  const std::string felt = "belief_" + column;
  return YAxis(data, 3, {column, felt}) + "plot " +
         Curve(data, column, LineStyle(palette::kTruth, kThick), has_key ? "true" : "") +
         ", \\\n  " +
         Curve(data, felt, LineStyle(palette::kBelief, "linewidth 1"), has_key ? "believed" : "");
}

// Heights of all feet, as they are and as they are wanted.
std::string Heights(const PlotData& data) {
  std::vector<std::string> curves;
  std::string plot = "plot " + ZeroLine();
  for (std::size_t i = 0; i < data.feet.size(); ++i) {
    const std::string suffix = data.feet[i] + "_z_m";
    curves.insert(curves.end(), {"truth_p_WF_" + suffix, "swing_p_WF_" + suffix});
    plot += ", \\\n  " + Curve(data, curves[2 * i], FaintStyle(palette::Foot(i)), "") + ", \\\n  " +
            Curve(data, curves[2 * i + 1], LineStyle(palette::Foot(i), kDashed), "");
  }
  return "set ylabel 'height of F (m)'\n" + YAxis(data, 3, curves, true) + plot + "\n";
}

std::string Pressures(const PlotData& data, bool is_x) {
  std::vector<std::string> curves;
  std::string plot = "plot " + ZeroLine();
  for (std::size_t i = 0; i < data.feet.size(); ++i) {
    curves.push_back("pressure_" + data.feet[i] + (is_x ? "_x_m" : "_y_m"));
    plot += ", \\\n  " + Curve(data, curves.back(), LineStyle(palette::Foot(i)), "");
  }
  return std::string("set ylabel 'CoP, ") + (is_x ? "x" : "y") + " from F (m)'\n" +
         YAxis(data, 3, curves, true) + plot;
}

}  // namespace

std::string ExternalWrenchScript(const PlotData& data) {
  std::string script = StartPanels(data, "push and what the controller takes it for", 3, 2);
  for (std::size_t axis = 0; axis < kAxes.size(); ++axis) {
    const bool is_last = axis + 1 == kAxes.size();
    for (const bool is_force : {true, false}) {
      script += is_last ? "set xlabel 'time (s)'\n" : "unset xlabel\n";
      script += "set ylabel '" + std::string(kAxes[axis]) + (is_force ? " (N)'" : " (N m)'") + "\n";
      script += axis > 0 ? "unset title\n"
                         : std::string("set title '") + (is_force ? "force" : "moment about C") +
                               "' offset 0,-0.6\n";
      const std::string suffix = std::string("_") + kAxes[axis] + (is_force ? "_N" : "_Nm");
      script += TrueAndFelt(data, (is_force ? "push_force_W" : "push_torque_C_W") + suffix,
                            is_last && is_force);
      if (is_last && is_force) script += ", \\\n  " + PushKey(data);
      script += "\n";
    }
  }
  return script + "unset multiplot\n";
}

std::string FeetScript(const PlotData& data) {
  std::string script = StartPanels(data, "height of the feet and their centres of pressure", 3, 1);
  script +=
      Heights(data) + Pressures(data, true) + "\nset xlabel 'time (s)'\n" + Pressures(data, false);
  for (std::size_t i = 0; i < data.feet.size(); ++i) {
    script += ", \\\n  keyentry with lines " + FaintStyle(palette::Foot(i)) + " title " +
              GnuplotText(data.feet[i]);
  }
  script += ", \\\n  keyentry with lines " + LineStyle(palette::kNominal, kDashed) +
            " title 'wanted', \\\n  " + PushKey(data) + "\n";
  return script + "unset multiplot\n";
}

}  // namespace sidestep::plot
