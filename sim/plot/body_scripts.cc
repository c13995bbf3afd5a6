// SPDX-License-Identifier: BSD-3-Clause
// Plots of what acts on the body: the push as it is and as it is felt, and how the feet stand.
#include <array>

#include "sim/plot/plot_script.h"
#include "sim/process/gnuplot.h"

namespace sidestep::plot {
namespace {

// A foot that bears less than this has no centre of pressure worth a line.
constexpr const char* kLeastLoad_N = "5";

std::string TrueAndFelt(const std::string& quantity, const std::string& suffix, bool has_key) {
  return "plot " +
         Curve("push_" + quantity + suffix, LineStyle(kTruthColor, "linewidth 1.6"),
               has_key ? "true" : "") +
         ", \\\n  " +
         Curve("belief_push_" + quantity + suffix,
               LineStyle(kReferenceColor, "linewidth 1.3 dashtype (6,3)"),
               has_key ? "believed" : "");
}

// Distance of the centre of pressure from F along an axis of W: -m_y / f_z and m_x / f_z.
std::string Pressure(const std::string& foot, bool is_x) {
  const std::string force = "column(" + GnuplotText("truth_f_F_W_" + foot + "_z_N") + ")";
  const std::string moment =
      "column(" + GnuplotText("truth_m_F_W_" + foot + (is_x ? "_y_Nm" : "_x_Nm")) + ")";
  return "(" + force + " > " + kLeastLoad_N + " ? " + (is_x ? "-" : "") + moment + "/" + force +
         " : NaN)";
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
      script += TrueAndFelt(is_force ? "force_W" : "torque_C_W", suffix, is_last && is_force);
      if (is_last && is_force) script += ", \\\n  " + PushKey(data);
      script += "\n";
    }
  }
  return script + "unset multiplot\n";
}

std::string FeetScript(const PlotData& data) {
  std::string script = StartPanels(data, "height of the feet and their centres of pressure", 3, 1);
  script +=
      "set ylabel 'height of F (m)'\nplot 0 with lines linecolor rgb \"#B0B0B0\" "
      "linewidth 0.5 notitle";
  for (std::size_t i = 0; i < data.feet.size(); ++i) {
    const std::string suffix = data.feet[i] + "_z_m";
    script +=
        ", \\\n  " + Curve("truth_p_WF_" + suffix, LineStyle(FootColor(i), "linewidth 1.5"), "");
    script += ", \\\n  " + Curve("swing_p_WF_" + suffix,
                                 LineStyle(FootColor(i), "linewidth 1.1 dashtype (5,3)"), "");
  }
  for (const bool is_x : {true, false}) {
    script += std::string("\nset ylabel 'CoP, ") + (is_x ? "x" : "y") + " from F (m)' offset 1\n";
    if (!is_x) script += "set xlabel 'time (s)'\n";
    script += "plot 0 with lines linecolor rgb \"#B0B0B0\" linewidth 0.5 notitle";
    for (std::size_t i = 0; i < data.feet.size(); ++i) {
      script += ", \\\n  '" + std::string(kThinnedFile) +
                "' using \"time_s\":" + Pressure(data.feet[i], is_x) + " with lines " +
                LineStyle(FootColor(i), "linewidth 1.4 ") +
                (is_x ? "notitle" : "title " + GnuplotText(data.feet[i]));
    }
  }
  script += ", \\\n  keyentry with lines " + LineStyle(kNominalColor, "dashtype (5,3)") +
            " title 'wanted', \\\n  " + PushKey(data) + "\n";
  return script + "unset multiplot\n";
}

}  // namespace sidestep::plot
