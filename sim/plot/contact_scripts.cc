// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <cmath>
#include <sstream>

#include "sim/plot/plot_script.h"
#include "sim/process/gnuplot.h"

namespace sidestep::plot {
namespace {

constexpr const char* kFootsteps = "'../footsteps.csv'";

// A gnuplot expression: a column of this foot's rows, undefined in others.
std::string OfFoot(const std::string& foot, const std::string& expression) {
  return "(strcol(\"foot\") eq " + GnuplotText(foot) + " ? " + expression + " : NaN)";
}

std::string Column(const std::string& name) { return "(column(" + GnuplotText(name) + "))"; }

// An arrow into the CoM for each push, with its newtons at the tail.
void AddPushArrows(const PlotData& data, std::ostream& script) {
  constexpr double kLength_m = 0.12;
  for (const PushMark& mark : data.push_marks) {
    const double force_N = std::hypot(mark.force_x_N, mark.force_y_N);
    if (!(force_N > 0.0)) continue;
    const double x_m = mark.x_m - kLength_m * mark.force_x_N / force_N;
    const double y_m = mark.y_m - kLength_m * mark.force_y_N / force_N;
    script << "set arrow from " << x_m << ", " << y_m << " to " << mark.x_m << ", " << mark.y_m
           << " front head size screen 0.012,22 filled linewidth 2 linecolor rgb \"" << kPushColor
           << "\"\nset label '" << std::lround(force_N) << " N' at " << x_m << ", " << y_m
           << " front center offset 0, " << (mark.force_y_N > 0.0 ? -0.7 : 0.7) << "\n";
  }
}

// Undefined also of steps that were moved less than the farthest.
std::string OfMovedFoot(const std::string& foot, double moved_m, const std::string& expression) {
  const auto moved = [](const char* axis) {
    return "(column(\"adjusted_" + std::string(axis) + "_m\")-column(\"nominal_" + axis +
           "_m\"))**2";
  };
  return OfFoot(foot, "(sqrt(" + moved("x") + "+" + moved("y") + ") > " + std::to_string(moved_m) +
                          " ? " + expression + " : NaN)");
}

// The four edges of the box that a moved foothold may be in, turned by the foot's yaw.
void AddBoxToTopView(const std::string& foot, const std::string& color, double moved_m,
                     std::ostream& script) {
  const std::string cosine = "cos(column(\"yaw_rad\"))", sine = "sin(column(\"yaw_rad\"))";
  const std::array<std::array<const char*, 2>, 4> corners{
      {{"lower", "lower"}, {"upper", "lower"}, {"upper", "upper"}, {"lower", "upper"}}};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const auto& next = corners[(i + 1) % corners.size()];
    const std::string x = Column(std::string("box_") + corners[i][0] + "_x_m");
    const std::string y = Column(std::string("box_") + corners[i][1] + "_y_m");
    const std::string dx = "(" + Column(std::string("box_") + next[0] + "_x_m") + "-" + x + ")";
    const std::string dy = "(" + Column(std::string("box_") + next[1] + "_y_m") + "-" + y + ")";
    const std::string from_x =
        Column("nominal_x_m") + "+" + cosine + "*" + x + "-" + sine + "*" + y;
    const std::string from_y =
        Column("nominal_y_m") + "+" + sine + "*" + x + "+" + cosine + "*" + y;
    script << ", \\\n  " << kFootsteps << " using " << OfMovedFoot(foot, moved_m, from_x) << ":("
           << from_y << "):(" << cosine << "*" << dx << "-" << sine << "*" << dy << "):(" << sine
           << "*" << dx << "+" << cosine << "*" << dy << ") with vectors nohead linecolor rgb \""
           << color << "\" linewidth 0.3 notitle";
  }
}

void AddFootToTopView(const std::string& foot, const std::string& color, double moved_m,
                      std::ostream& script) {
  AddBoxToTopView(foot, color, moved_m, script);
  script << ", \\\n  " << kFootsteps << " using " << OfFoot(foot, Column("nominal_x_m")) << ":"
         << Column("nominal_y_m") << ":(" << Column("adjusted_x_m") << "-" << Column("nominal_x_m")
         << "):(" << Column("adjusted_y_m") << "-" << Column("nominal_y_m")
         << ") with vectors head size screen 0.006,25 filled linecolor rgb \"" << color
         << "\" linewidth 1 notitle"
         << ", \\\n  " << kFootsteps << " using " << OfFoot(foot, Column("nominal_x_m")) << ":"
         << Column("nominal_y_m")
         << " with points pointtype 6 pointsize 1.1 linewidth 1.4 linecolor rgb \"" << kNominalColor
         << "\" notitle"
         << ", \\\n  " << kFootsteps << " using " << OfFoot(foot, Column("adjusted_x_m")) << ":"
         << Column("adjusted_y_m") << " with points pointtype 7 pointsize 0.9 linecolor rgb \""
         << color << "\" title " << GnuplotText(foot + ", adjusted") << ", \\\n  " << kFootsteps
         << " using " << OfFoot(foot, Column("realised_x_m")) << ":" << Column("realised_y_m")
         << " with points pointtype 2 pointsize 0.7 linewidth 1.2 linecolor rgb \"" << color
         << "\" notitle";
}

// Ranges of one scale that hold the CoM and the footholds and fill the canvas; boxes may reach out.
void SetTopViewRanges(bool has_footsteps, std::ostream& script) {
  constexpr double kMargin_m = 0.12;
  constexpr double kAspect = 1.63;  // of the area between the margins below
  script << "stats '" << kThinnedFile << "' using " << Column("truth_p_WC_x_m") << ":"
         << Column("truth_p_WC_y_m") << " name 'C' nooutput\n"
         << "x0 = C_min_x; x1 = C_max_x; y0 = C_min_y; y1 = C_max_y\n";
  if (has_footsteps) {
    script << "stats " << kFootsteps << " using " << Column("adjusted_x_m") << ":"
           << Column("adjusted_y_m") << " name 'F' nooutput\n"
           << "x0 = F_min_x < x0 ? F_min_x : x0; x1 = F_max_x > x1 ? F_max_x : x1\n"
           << "y0 = F_min_y < y0 ? F_min_y : y0; y1 = F_max_y > y1 ? F_max_y : y1\n";
  }
  script << "w = x1 - x0 + " << 2.0 * kMargin_m << "; h = y1 - y0 + " << 2.0 * kMargin_m << "\n"
         << "w = w < " << kAspect << " * h ? " << kAspect << " * h : w; h = w / " << kAspect << "\n"
         << "set xrange [0.5 * (x0 + x1 - w):0.5 * (x0 + x1 + w)]\n"
         << "set yrange [0.5 * (y0 + y1 - h):0.5 * (y0 + y1 + h)]\n";
}

std::string FootCurve(const std::string& expression, const std::string& color,
                      const std::string& title) {
  return "'" + std::string(kThinnedFile) + "' using \"time_s\":(" + expression +
         ") with lines linecolor rgb \"" + color + "\" linewidth 1.4 " +
         (title.empty() ? "notitle" : "title " + GnuplotText(title));
}

}  // namespace

std::string TopViewScript(const PlotData& data) {
  std::ostringstream script;
  script << "set title " << GnuplotText(data.title + ": footsteps and centre of mass from above")
         << "\nset lmargin at screen 0.10\nset rmargin at screen 0.975\n"
         << "set bmargin at screen 0.165\nset tmargin at screen 0.93\n"
         << "set size ratio -1\nset xlabel 'x, forward (m)'\nset ylabel 'y, left (m)'\n";
  SetTopViewRanges(data.has_footsteps, script);
  AddPushArrows(data, script);
  script << "plot '" << kThinnedFile << "' using \"reference_p_WC_x_m\":\"reference_p_WC_y_m\" "
         << "with lines linecolor rgb \"" << kReferenceColor
         << "\" linewidth 1.6 title 'CoM, reference'"
         << ", \\\n  '" << kThinnedFile << "' using \"truth_p_WC_x_m\":\"truth_p_WC_y_m\" "
         << "with lines linecolor rgb \"" << kMpcColor << "\" linewidth 1.6 title 'CoM, true'";
  if (data.has_footsteps) {
    for (std::size_t i = 0; i < data.feet.size(); ++i) {
      AddFootToTopView(data.feet[i], FootColor(i), data.moved_m, script);
    }
    script << ", \\\n  keyentry with points pointtype 6 linewidth 1.4 linecolor rgb \""
           << kNominalColor << "\" title 'nominal'"
           << ", \\\n  keyentry with points pointtype 2 linecolor rgb \"" << kNominalColor
           << "\" title 'realised'"
           << ", \\\n  keyentry with boxes linecolor rgb \"" << kNominalColor
           << "\" linewidth 0.6 fillstyle empty title 'allowed'";
  }
  script << "\n";
  return script.str();
}

std::string ContactForceScript(const PlotData& data) {
  std::string script = StartPanels(data, "force of the ground on each foot", 3, 1);
  for (const char* axis : {"x", "y", "z"}) {
    const bool has_key = *axis == 'z';
    script += std::string("set ylabel '") + axis + " (N)'\n";
    if (has_key) script += "set xlabel 'time (s)'\n";
    script += "plot 0 with lines linecolor rgb \"#B0B0B0\" linewidth 0.5 notitle";
    for (std::size_t i = 0; i < data.feet.size(); ++i) {
      const std::string suffix = data.feet[i] + "_" + axis + "_N";
      const std::string color = "linecolor rgb \"" + FootColor(i) + "\" ";
      script += ", \\\n  " + Curve("truth_f_F_W_" + suffix, color + "linewidth 1.5",
                                   has_key ? data.feet[i] + ", true" : "");
      script += ", \\\n  " + Curve("mpc_f_F_W_" + suffix, color + "linewidth 1.1 dashtype (5,3)",
                                   has_key ? data.feet[i] + ", MPC" : "");
    }
    if (has_key) script += ", \\\n  " + PushKey(data);
    script += "\n";
  }
  return script + "unset multiplot\n";
}

std::string AdjustmentScript(const PlotData& data) {
  std::string script = StartPanels(data, "footholds moved from their nominal place", 2, 1);
  for (const char* axis : {"x", "y"}) {
    const bool has_key = *axis == 'y';
    script += std::string("set ylabel '") + axis + (has_key ? ", left (m)'\n" : ", forward (m)'\n");
    if (has_key) script += "set xlabel 'time (s)'\n";
    script += "plot 0 with lines linecolor rgb \"#B0B0B0\" linewidth 0.5 notitle";
    for (std::size_t i = 0; i < data.feet.size(); ++i) {
      const std::string& foot = data.feet[i];
      const std::string suffix = foot + "_" + axis + "_m";
      const std::string moved =
          Column("adjusted_p_WF_" + suffix) + "-" + Column("nominal_p_WF_" + suffix);
      script += ", \\\n  " + FootCurve(moved, FootColor(i), has_key ? foot + ", planned" : "");
      if (!data.has_footsteps) continue;
      const std::string stem = std::string("_") + axis + "_m";
      script += std::string(", \\\n  ") + kFootsteps + " using " + OfFoot(foot, Column("start_s")) +
                ":(" + Column("adjusted" + stem) + "-" + Column("nominal" + stem) +
                "):" + Column("box_lower" + stem) + ":" + Column("box_upper" + stem) +
                " with yerrorbars pointtype 7 pointsize 0.7 linewidth 0.8 linecolor rgb \"" +
                FootColor(i) + "\" " +
                (has_key ? "title " + GnuplotText(foot + ", taken (bar: allowed)") : "notitle");
    }
    if (has_key) script += ", \\\n  " + PushKey(data);
    script += "\n";
  }
  return script + "unset multiplot\n";
}

}  // namespace sidestep::plot
