// SPDX-License-Identifier: BSD-3-Clause
#include "sim/plot/plot_script.h"
#include "sim/process/gnuplot.h"

#include <array>
#include <sstream>

namespace sidestep::plot {

std::string FootColor(std::size_t foot) {
  static const std::array<const char*, 4> kColors{"#0072B2", "#D55E00", "#009E73", "#CC79A7"};
  return kColors[foot % kColors.size()];
}

std::vector<PlotScript> AllScripts() {
  return {{"top_view", TopViewScript},  {"step_adjustment", AdjustmentScript},
          {"com", ComScript},           {"contact_forces", ContactForceScript},
          {"feet", FeetScript},         {"external_wrench", ExternalWrenchScript},
          {"gait", GaitScript},         {"phase_portrait", PhasePortraitScript},
          {"momentum", MomentumScript}, {"mpc_time", SolveScript}};
}

std::string Preamble(const std::string& name) {
  return "# Draw again with: gnuplot " + name + ".gp   or: gnuplot -e \"format='png'\" " + name +
         R"(.gp
if (!exists("format")) format = "svg"
if (format eq "png") {
  set terminal pngcairo size 1000,700 font "DejaVu Sans,11" noenhanced linewidth 1.3
} else {
  set terminal svg size 1000,700 dynamic font "DejaVu Sans,14" noenhanced linewidth 1.3
}
set output ")" +
         name + R"(.".format
set encoding utf8
set datafile separator comma
set datafile columnheaders
set border 3 linewidth 0.8
set tics nomirror out scale 0.6
set grid linecolor rgb "#B0B0B0" linewidth 0.4 dashtype solid
set key noautotitle at screen 0.5,0.012 center bottom vertical maxrows 2 Left reverse samplen 2.5 width 1
)";
}

std::string StartPanels(const PlotData& data, const std::string& title, int rows, int columns) {
  std::ostringstream script;
  script << "set xrange [" << data.start_s << ":" << data.end_s << "]\n"
         << "set xtics autofreq\n";
  int object = 1;
  for (const Stretch& push : data.pushes) {
    script << "set object " << object++ << " rectangle from " << push.start_s << ", graph 0 to "
           << push.end_s << ", graph 1 behind fillcolor rgb \"" << kPushColor
           << "\" fillstyle transparent solid 0.16 noborder  # push\n";
  }
  script << "set multiplot layout " << rows << "," << columns << " title "
         << GnuplotText(data.title + ": " + title)
         << " margins 0.10,0.975,0.165,0.91 spacing 0.10,0.075\n";
  return script.str();
}

std::string Curve(const std::string& column, const std::string& style, const std::string& title) {
  return "'" + std::string(kThinnedFile) + "' using 'time_s':" + GnuplotText(column) +
         " with lines " + style + (title.empty() ? " notitle" : " title " + GnuplotText(title));
}

std::string LineStyle(const std::string& color, const std::string& more) {
  return "linecolor rgb \"" + color + "\" " + more;
}

std::string PushKey(const PlotData& data) {
  if (data.pushes.empty()) return "keyentry with points pointtype 0 title ' '";
  std::string key = "keyentry with boxes fillcolor rgb \"";
  key += kPushColor;
  key += "\" fillstyle transparent solid 0.16 noborder title 'push'";
  return key;
}

}  // namespace sidestep::plot
