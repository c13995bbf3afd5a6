// SPDX-License-Identifier: BSD-3-Clause
// The gait diagram: who stands when, and who was to.
#include <algorithm>
#include <cmath>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

#include "sim/palette/palette.h"
#include "sim/plot/plot_script.h"
#include "sim/process/gnuplot.h"

namespace sidestep::plot {
namespace {

// As many steps of a foot as a row of the diagram shows well; a long run is broken into rows.
constexpr double kStepsARow = 12.0;
constexpr int kMostRows = 4;
constexpr double kShortestStep_s = 0.05;  // shorter, a foot chatters

// Heights of the bars about a foot's line, which are 1 apart.
constexpr double kTruthTop = 0.36, kTruthBottom = -0.04;
constexpr double kNamesTop = 0.9;  // above it, room for the gaits' names
constexpr double kPlannedTop = -0.10, kPlannedBottom = -0.30;

int RowsOf(const PlotData& data) {
  const auto is_step = [](const Stretch& stance) {
    return stance.end_s - stance.start_s >= kShortestStep_s;
  };
  std::ptrdiff_t steps = 0;
  for (const FootContacts& foot : data.contacts) {
    steps = std::max(steps, std::count_if(foot.truth.begin(), foot.truth.end(), is_step));
  }
  return std::clamp(static_cast<int>(std::ceil(static_cast<double>(steps) / kStepsARow)), 1,
                    kMostRows);
}

// A table of bars: start, end and height in the diagram, as boxxyerror takes them.
std::string Bars(const std::string& name, const std::vector<Stretch>& stretches, double bottom,
                 double top) {
  std::ostringstream rows;
  for (const Stretch& stretch : stretches) {
    rows << stretch.start_s << " " << bottom << " " << stretch.start_s << " " << stretch.end_s
         << " " << bottom << " " << top << "\n";
  }
  return DataBlock(name, rows.str(), 6);
}

std::string BarCurve(const std::string& name, const std::string& style, const std::string& title) {
  return "$" + name + " using 1:2:3:4:5:6 with boxxyerror " + style +
         (title.empty() ? " notitle" : " title " + GnuplotText(title));
}

std::string FillStyle(const std::string& color, const std::string& density) {
  return "linecolor rgb \"" + color + "\" linewidth 0.6 fillstyle transparent solid " + density +
         " border";
}

// Foot 0 is on top; flights have a line of their own below the feet.
void AddTables(const PlotData& data, std::ostream& script) {
  for (std::size_t i = 0; i < data.contacts.size(); ++i) {
    const auto line = static_cast<double>(data.contacts.size() - i);
    const std::string number = std::to_string(i);
    script << Bars("truth" + number, data.contacts[i].truth, line + kTruthBottom, line + kTruthTop)
           << Bars("planned" + number, data.contacts[i].planned, line + kPlannedBottom,
                   line + kPlannedTop);
  }
  if (!data.flights.empty()) script << Bars("flight", data.flights, -0.2, 0.2);
}

void SetLines(const PlotData& data, std::ostream& script) {
  script << "set ytics (";
  for (std::size_t i = 0; i < data.feet.size(); ++i) {
    script << (i == 0 ? "" : ", ") << GnuplotText(data.feet[i]) << " " << data.feet.size() - i;
  }
  const bool has_flights = !data.flights.empty();
  script << (has_flights ? ", 'flight' 0)" : ")") << "\nset yrange ["
         << (has_flights ? "-0.45" : "0.55") << ":"
         << static_cast<double>(data.feet.size()) + kNamesTop << "]\nunset grid\nset grid xtics\n";
}

void AddGaitNames(const PlotData& data, std::ostream& script) {
  int arrow = 1;
  for (const AskedGaitStart& gait : data.gaits) {
    if (gait.start_s < data.start_s || gait.start_s >= data.end_s) continue;
    script << "set arrow " << arrow++ << " from " << gait.start_s << ", graph 0 to " << gait.start_s
           << ", graph 1 nohead linecolor rgb \"" << palette::kNominal
           << "\" dashtype (4,4)\nset label " << GnuplotText(" " + gait.type) << " at "
           << gait.start_s << ", graph 0.96\n";
  }
}

std::string BarCurves(const PlotData& data, bool has_key) {
  std::string script;
  for (std::size_t i = 0; i < data.contacts.size(); ++i) {
    const std::string number = std::to_string(i);
    script += (i == 0 ? "plot " : ", \\\n  ") +
              BarCurve("truth" + number, FillStyle(palette::Foot(i), "0.85"),
                       has_key ? data.feet[i] + ", stands" : "") +
              ", \\\n  " +
              BarCurve("planned" + number, FillStyle(palette::Foot(i), "0.25"),
                       has_key ? data.feet[i] + ", planned" : "");
  }
  if (data.flights.empty()) return script;
  return script + ", \\\n  " +
         BarCurve("flight", FillStyle(palette::kNominal, "0.5"), has_key ? "no foot stands" : "");
}

}  // namespace

std::string GaitScript(const PlotData& data) {
  std::ostringstream script;
  const int rows = RowsOf(data);
  const double row_s = (data.end_s - data.start_s) / rows;
  script << StartPanels(data, "who stands when", rows, 1);
  const double length_em = PanelSize_em(data.canvas, rows, 1).x();
  script << "set xtics " << TimeStep_s(row_s, length_em) << "\n";
  AddTables(data, script);
  SetLines(data, script);
  AddGaitNames(data, script);
  for (int row = 0; row < rows; ++row) {
    const bool is_last = row + 1 == rows;
    script << "set xrange [" << data.start_s + row * row_s << ":"
           << data.start_s + (row + 1) * row_s << "]\n";
    if (is_last) script << "set xlabel 'time (s)'\n";
    script << BarCurves(data, is_last);
    if (is_last && !data.pushes.empty()) script << ", \\\n  " << PushKey(data);
    script << "\n";
  }
  return script.str() + "unset multiplot\n";
}

}  // namespace sidestep::plot
