// SPDX-License-Identifier: BSD-3-Clause
// Phase portraits: how the cycle of a gait closes, and what a push makes of it.
#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

#include "models/support/require.h"
#include "sim/plot/plot_script.h"
#include "sim/process/gnuplot.h"

namespace sidestep::plot {
namespace {

constexpr double kTicsAPanel = 5.0;  // about: gnuplot's own would overlap where little changes

struct PhasePanel {
  const char *value, *rate, *title, *value_label, *rate_label;
};

const PhasePanel& PanelOf(const std::string& value) {
  static constexpr std::array<PhasePanel, 4> kPanels{
      {{"truth_p_WC_y_m", "truth_v_WC_y_mps", "CoM to the side", "y (m)", "speed (m/s)"},
       {"truth_p_WC_z_m", "truth_v_WC_z_mps", "height of the CoM", "z (m)", "speed (m/s)"},
       {"truth_roll_rad", "truth_roll_radps", "roll of the base", "roll (rad)", "rate (rad/s)"},
       {"truth_pitch_rad", "truth_pitch_radps", "pitch of the base", "pitch (rad)",
        "rate (rad/s)"}}};
  const auto found = std::find_if(kPanels.begin(), kPanels.end(),
                                  [&](const PhasePanel& panel) { return panel.value == value; });
  SIDESTEP_REQUIRE(found != kPanels.end(), value);
  return *found;
}

// The next of 1, 2 and 5 times a power of ten.
double NiceStep(double step) {
  const double power = std::pow(10.0, std::floor(std::log10(step)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= step) return factor * power;
  }
  return 10.0 * power;
}

// One panel of a quantity against its rate. What came before the first push is drawn last, on top.
std::string Portrait(const PlotData& data, const std::string& value, const std::string& rate,
                     bool has_key) {
  const auto part = [&](const std::string& condition, const std::string& style,
                        const std::string& title) {
    return "'" + std::string(kPhaseFile) + "' using (" + condition + " ? column(\"" + value +
           "\") : NaN):\"" + rate + "\" with lines " + style +
           (has_key ? " title " + GnuplotText(title) : " notitle");
  };
  if (data.pushes.empty()) {
    return "plot " + part("1", LineStyle(kTruthColor, "linewidth 0.8"), "true");
  }
  return "plot " +
         part("is_after(column(\"time_s\"))", LineStyle(kMpcColor, "linewidth 0.6"),
              "after a push") +
         ", \\\n  " +
         part("is_pushed(column(\"time_s\"))", LineStyle(kPushColor, "linewidth 1.2"), "pushed") +
         ", \\\n  " +
         part("is_before(column(\"time_s\"))", LineStyle(kTruthColor, "linewidth 1.2"),
              "before the first push");
}

void DefinePushTimes(const PlotData& data, std::ostream& script) {
  double first_s = data.end_s;
  script << "is_pushed(t) = 0";
  for (const Stretch& push : data.pushes) {
    script << " || (t >= " << push.start_s << " && t <= " << push.end_s << ")";
    first_s = std::min(first_s, push.start_s);
  }
  script << "\nis_before(t) = t <= " << first_s << "\nis_after(t) = t >= " << first_s
         << " && !is_pushed(t)\n";
}

}  // namespace

std::string PhasePortraitScript(const PlotData& data) {
  std::ostringstream script;
  const std::size_t rows = data.phases.size() > 2 ? 2 : 1;
  const std::size_t columns = data.phases.size() > 1 ? 2 : 1;
  script << "set multiplot layout " << rows << "," << columns << " title "
         << GnuplotText(data.title + ": phase portraits, true motion")
         << " margins 0.10,0.975,0.165,0.91 spacing 0.11,0.14\n";
  DefinePushTimes(data, script);
  if (data.phases.empty()) script << "set xrange [0:1]\nset yrange [0:1]\nplot NaN notitle\n";
  for (const PhaseRange& phase : data.phases) {
    const bool is_last = &phase == &data.phases.back();
    const PhasePanel& panel = PanelOf(phase.column);
    script << "set title " << GnuplotText(panel.title) << " offset 0,-0.6\nset xlabel "
           << GnuplotText(panel.value_label) << " offset 0,0.4\nset ylabel "
           << GnuplotText(panel.rate_label) << " offset 0.5\nset xtics "
           << NiceStep((phase.max - phase.min) / kTicsAPanel) << "\n"
           << Portrait(data, panel.value, panel.rate, is_last) << "\n";
  }
  return script.str() + "unset multiplot\n";
}

}  // namespace sidestep::plot
