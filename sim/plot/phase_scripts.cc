// SPDX-License-Identifier: BSD-3-Clause
// Phase portraits: how the cycle of a gait closes, and what a push makes of it.
#include <algorithm>
#include <array>
#include <sstream>
#include <string>

#include "models/support/require.h"
#include "sim/palette/palette.h"
#include "sim/plot/plot_script.h"
#include "sim/process/gnuplot.h"

namespace sidestep::plot {
namespace {

struct PhasePanel {
  const char *value, *title, *value_label, *rate_label;
};

const PhasePanel& PanelOf(const std::string& value) {
  static constexpr std::array<PhasePanel, 4> kPanels{
      {{"truth_p_WC_y_m", "CoM to the side", "y (m)", "speed (m/s)"},
       {"truth_p_WC_z_m", "height of the CoM", "z (m)", "speed (m/s)"},
       {"truth_roll_rad", "roll of the base", "roll (rad)", "rate (rad/s)"},
       {"truth_pitch_rad", "pitch of the base", "pitch (rad)", "rate (rad/s)"}}};
  const auto found = std::find_if(kPanels.begin(), kPanels.end(),
                                  [&](const PhasePanel& panel) { return panel.value == value; });
  SIDESTEP_REQUIRE(found != kPanels.end(), value);
  return *found;
}

// One panel of a quantity against its rate. What came before the first push is drawn last, on top.
std::string Portrait(const PlotData& data, const std::string& value, bool has_key) {
  const auto part = [&](const char* when, const std::string& style, const char* title) {
    return Curve(data, value + when, style, has_key ? title : "");
  };
  if (data.pushes.empty()) {
    return "plot " + part("_before", LineStyle(palette::kTruth, "linewidth 0.8"), "true");
  }
  return "plot " + part("_after", LineStyle(palette::kNominal, "linewidth 0.8"), "after a push") +
         ", \\\n  " + part("_pushed", LineStyle(palette::kPush, "linewidth 1.3"), "pushed") +
         ", \\\n  " +
         part("_before", LineStyle(palette::kTruth, "linewidth 1.3"), "before the first push");
}

// Ranges that hold all three parts.
std::string Axes(const PlotData& data, const std::string& value, const Eigen::Vector2d& panel_em) {
  Span x, y;
  for (const char* when : {"_before", "_pushed", "_after"}) {
    x.Include(data.curves.XOf(value + when));
    y.Include(data.curves.YOf(value + when));
  }
  return AxisLines("x", x, panel_em.x()) + AxisLines("y", y, panel_em.y());
}

}  // namespace

std::string PhasePortraitScript(const PlotData& data) {
  const int rows = data.phases.size() > 2 ? 2 : 1;
  const int columns = data.phases.size() > 1 ? 2 : 1;
  const Eigen::Vector2d panel_em =
      PanelSize_em(data.canvas, rows, columns, kBetweenLabelledRows_em);
  std::ostringstream script;
  script << StartMultiplot(data, "phase portraits, true motion", rows, columns,
                           kBetweenLabelledRows_em);
  if (data.phases.empty()) script << "set xrange [0:1]\nset yrange [0:1]\nplot NaN notitle\n";
  for (const std::string& value : data.phases) {
    const PhasePanel& panel = PanelOf(value);
    script << "set title " << GnuplotText(panel.title) << " offset 0,-0.6\nset xlabel "
           << GnuplotText(panel.value_label) << " offset 0,0.5\nset ylabel "
           << GnuplotText(panel.rate_label) << "\n"
           << Axes(data, value, panel_em) << Portrait(data, value, &value == &data.phases.back())
           << "\n";
  }
  return script.str() + "unset multiplot\n";
}

}  // namespace sidestep::plot
