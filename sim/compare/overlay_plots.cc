// SPDX-License-Identifier: BSD-3-Clause
#include "sim/compare/overlay_plots.h"

#include <algorithm>
#include <array>
#include <functional>

#include "sim/palette/palette.h"
#include "sim/plot/draw_scripts.h"
#include "sim/plot/plot_data.h"
#include "sim/plot/plot_script.h"
#include "sim/process/gnuplot.h"
#include "sim/record/output_file.h"

namespace sidestep {
namespace {

namespace fs = std::filesystem;
using plot::LineStyle;
using plot::PlotData;

// How one of the two is drawn.
struct Look {
  const char* word;
  const char* curves;  // their file
  const char* prefix;  // of their macros
  const char* color;
  const char* line;  // gnuplot's words
  const char* point;
};
constexpr std::array<Look, 2> kLooks{
    {{"A", "a.bin", "a_", palette::Run(0), "linewidth 2.4", "pointtype 7"},
     {"B", "b.bin", "b_", palette::Run(1), "linewidth 1.4 dashtype (5,3)", "pointtype 6"}}};

// Both runs, and their axes: pushes of both, times from the first row to the last, no curves.
struct Overlay {
  PlotData axes;
  std::array<PlotData, 2> runs;
};

std::string RunCurve(const Overlay& overlay, std::size_t run, const std::string& curve,
                     const std::string& title) {
  return plot::Curve(overlay.runs[run], curve, LineStyle(kLooks[run].color, kLooks[run].line),
                     title);
}

std::string KeyOf(const Overlay& overlay, std::size_t run) {
  return std::string(kLooks[run].word) + ": " + overlay.runs[run].title;
}

// One panel over time, of `rows`: that column of every run that has it.
std::string TimePanel(const Overlay& overlay, const std::string& column, bool has_key, int rows,
                      const std::function<bool(const PlotData&)>& has_column) {
  std::string script = "plot NaN notitle";
  plot::Span span;
  for (std::size_t run = 0; run < kLooks.size(); ++run) {
    if (!has_column(overlay.runs[run])) continue;
    span.Include(overlay.runs[run].curves.YOf(column));
    script +=
        ", \\\n  " + RunCurve(overlay, run, column, has_key ? KeyOf(overlay, run) : std::string());
  }
  if (has_key) script += ", \\\n  " + plot::PushKey(overlay.axes);
  const double height_em = plot::PanelSize_em(overlay.axes.canvas, rows, 1).y();
  return plot::AxisLines("y", span, height_em) + script + "\n";
}

bool Always(const PlotData& /*run*/) { return true; }

std::string ComOverlay(const Overlay& overlay) {
  std::string script = plot::StartPanels(overlay.axes, "centre of mass, true", 3, 2);
  for (const char* axis : plot::kAxes) {
    const bool is_first = *axis == 'x', is_last = *axis == 'z';
    for (const bool is_position : {true, false}) {
      script += is_last ? "set xlabel 'time (s)'\n" : "unset xlabel\n";
      script += "set ylabel '" + std::string(axis) + (is_position ? " (m)'" : " (m/s)'") +
                " offset 0.5\n";
      script += !is_first ? "unset title\n"
                          : std::string("set title '") + (is_position ? "position" : "velocity") +
                                "' offset 0,-0.6\n";
      const std::string column = is_position ? std::string("truth_p_WC_") + axis + "_m"
                                             : std::string("truth_v_WC_") + axis + "_mps";
      script += TimePanel(overlay, column, is_last && is_position, 3, Always);
    }
  }
  return script + "unset multiplot\n";
}

// Realised footholds; x and y.
std::string StepsTable(const PlotData& data, const std::string& name) {
  std::string rows;
  for (const plot::PlottedStep& plotted : data.steps) {
    const auto& p_WF = plotted.step.realised_p_WF;
    if (p_WF) rows += plot::Number(p_WF->x()) + " " + plot::Number(p_WF->y()) + "\n";
  }
  return plot::DataBlock(name, rows, 2);
}

std::string StepsOverlay(const Overlay& overlay) {
  std::string script =
      "set title " + GnuplotText(overlay.axes.title + ": footholds and centre of mass from above") +
      "\nset size ratio -1\nset bmargin 6\nset xlabel 'x, forward (m)'\n"
      "set ylabel 'y, left (m)'\n";
  std::string curves = "plot NaN notitle";
  for (std::size_t run = 0; run < kLooks.size(); ++run) {
    const Look& look = kLooks[run];
    const std::string table = std::string(look.prefix) + "steps";
    script += StepsTable(overlay.runs[run], table);
    curves += ", \\\n  " + RunCurve(overlay, run, "truth_path", KeyOf(overlay, run)) + ", \\\n  $" +
              table + " using 1:2 with points " + look.point + " pointsize 0.9 linecolor rgb \"" +
              look.color + "\" title '" + look.word + ": footholds, realised'";
  }
  return script + curves + "\n";
}

// Feet of both runs, in the first one's order.
std::vector<std::string> FeetOfBoth(const Overlay& overlay) {
  std::vector<std::string> feet = overlay.runs[0].feet;
  for (const std::string& foot : overlay.runs[1].feet) {
    if (std::find(feet.begin(), feet.end(), foot) == feet.end()) feet.push_back(foot);
  }
  return feet;
}

// A panel a foot and axis; those of a foot below each other.
std::string FeetPanels(const Overlay& overlay, const std::string& title,
                       const std::vector<const char*>& axes, const std::string& stem,
                       const std::string& unit) {
  const std::vector<std::string> feet = FeetOfBoth(overlay);
  std::string script = plot::StartPanels(overlay.axes, title, static_cast<int>(axes.size()),
                                         static_cast<int>(feet.size()));
  for (const char* axis : axes) {
    const bool is_first = axis == axes.front(), is_last = axis == axes.back();
    for (const std::string& foot : feet) {
      script += is_last ? "set xlabel 'time (s)'\n" : "unset xlabel\n";
      script += "set ylabel '" + std::string(axis) + " (" + unit + ")'\n";
      script += is_first ? "set title " + GnuplotText(foot) + " offset 0,-0.6\n" : "unset title\n";
      const auto has_foot = [&](const PlotData& run) {
        return std::find(run.feet.begin(), run.feet.end(), foot) != run.feet.end();
      };
      script += TimePanel(overlay, stem + foot + "_" + axis + "_" + unit,
                          is_last && foot == feet.front(), static_cast<int>(axes.size()), has_foot);
    }
  }
  return script + "unset multiplot\n";
}

std::string ScriptOf(const std::string& name, const Overlay& overlay) {
  if (name == "com") return ComOverlay(overlay);
  if (name == "steps") return StepsOverlay(overlay);
  if (name == "foot_heights") {
    return FeetPanels(overlay, "height of the feet, true", {"z"}, "truth_p_WF_", "m");
  }
  return FeetPanels(overlay, "force of the ground on each foot, true", {"x", "y", "z"},
                    "truth_f_F_W_", "N");
}

Overlay LoadOverlay(const fs::path& first, const fs::path& second) {
  const auto load = [](const fs::path& run_dir, const Look& look) {
    return plot::LoadPlotData(run_dir, plot::CurveFile(look.curves, look.prefix));
  };
  Overlay overlay{{}, {load(first, kLooks[0]), load(second, kLooks[1])}};
  const auto& [a, b] = overlay.runs;
  overlay.axes.title = "A and B";
  overlay.axes.canvas = a.canvas;
  overlay.axes.pushes = a.pushes;
  overlay.axes.start_s = std::min(a.start_s, b.start_s);
  overlay.axes.end_s = std::max(a.end_s, b.end_s);
  for (const plot::Stretch& push : b.pushes) {
    const bool is_there = std::any_of(a.pushes.begin(), a.pushes.end(), [&](const auto& other) {
      return other.start_s == push.start_s && other.end_s == push.end_s;
    });
    if (!is_there) overlay.axes.pushes.push_back(push);
  }
  return overlay;
}

}  // namespace

const std::vector<OverlayPlot>& OverlayPlots() {
  static const std::vector<OverlayPlot> kPlots{
      {"com", "Centre of mass of both runs over time"},
      {"steps", "Footholds and centre of mass of both runs from above"},
      {"foot_heights", "Heights of the feet of both runs over time"},
      {"contact_forces", "Force of the ground on each foot in both runs over time"}};
  return kPlots;
}

void PlotOverlay(const fs::path& first, const fs::path& second, const fs::path& folder) {
  const Overlay overlay = LoadOverlay(first, second);
  fs::create_directories(folder);
  for (const PlotData& run : overlay.runs) {
    WriteWholeFile(folder / run.curves.file(), run.curves.bytes());
  }
  std::vector<std::string> names;
  for (const OverlayPlot& one : OverlayPlots()) {
    const std::string body = ScriptOf(one.name, overlay);
    const std::string definitions =
        overlay.runs[0].curves.Definitions(body) + overlay.runs[1].curves.Definitions(body);
    names.push_back(one.name);
    WriteWholeFile(folder / (one.name + ".gp"),
                   plot::ScriptText(overlay.axes.canvas, one.name, definitions, body));
  }
  plot::DrawScripts(names, {"svg", "png"}, folder);
}

}  // namespace sidestep
