// SPDX-License-Identifier: BSD-3-Clause
#include "sim/plot/plot_script.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>

#include "sim/palette/palette.h"
#include "sim/process/gnuplot.h"

namespace sidestep::plot {
namespace {

constexpr double kLetter_em = 0.6;    // a letter's width: DejaVu Sans' mean is 0.57
constexpr double kKeyRow_em = 1.4;    // a line of a legend
constexpr double kBelow_em = 6.2;     // tics, label and air between panels and legend
constexpr double kTicX_em = 5.5;      // room that a number wants along x
constexpr double kTicY_em = 1.9;      // along y
constexpr double kAxisMargin = 0.05;  // of the range, beyond what is drawn
constexpr double kLeastRange = 1e-6;  // what moves less, in any unit, stands still,
constexpr double kLeastShare = 1e-4;  // and less than that of its value, as six digits can't tell
constexpr double kStillRange = 0.01;  // of the value, shown about it

int KeyRows(const Canvas& canvas) { return canvas.is_narrow() ? 4 : 2; }

}  // namespace

const std::vector<PlotScript>& AllScripts() {
  static const std::vector<PlotScript> kScripts{
      {"top_view", TopViewScript},  {"step_adjustment", AdjustmentScript},
      {"com", ComScript},           {"contact_forces", ContactForceScript},
      {"feet", FeetScript},         {"external_wrench", ExternalWrenchScript},
      {"gait", GaitScript},         {"phase_portrait", PhasePortraitScript},
      {"momentum", MomentumScript}, {"mpc_time", SolveScript}};
  return kScripts;
}

std::string ScriptText(const Canvas& canvas, const std::string& name,
                       const std::string& definitions, const std::string& body) {
  return "# Draw again with: gnuplot " + name + ".gp   or: gnuplot -e \"format='png'\" " + name +
         ".gp   or 'pdf'\nreset\n" + TerminalLines(canvas, name) +
         R"(set encoding utf8
set border 3 linewidth 0.8
set tics nomirror out scale 0.6
set grid linecolor rgb ")" +
         palette::kGrid + R"(" linewidth 0.4 dashtype solid
set key noautotitle at screen 0.5,0.012 center bottom vertical maxrows )" +
         std::to_string(KeyRows(canvas)) + " Left reverse samplen 2.5 width 1\n" + definitions +
         body;
}

std::string Number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

double NiceStep(double step) {
  const double power = std::pow(10.0, std::floor(std::log10(step)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= step * (1.0 - 1e-9)) return factor * power;
  }
  return 10.0 * power;
}

std::string TitleText(const PlotData& data, const std::string& what) {
  const std::string whole = data.title + ": " + what;
  const bool fits = kLetter_em * static_cast<double>(whole.size()) < data.canvas.width_em() - 2.0;
  return GnuplotText(fits ? whole : what);
}

Margins MarginsOf(const Canvas& canvas) {
  Margins margins;
  margins.bottom = kBelow_em + kKeyRow_em * KeyRows(canvas);
  if (!canvas.is_narrow()) return margins;
  margins.left = 7.2;
  margins.between_columns = 7.4;
  margins.right = 1.2;
  return margins;
}

Eigen::Vector2d PanelSize_em(const Canvas& canvas, int rows, int columns, double between_rows_em) {
  const Margins edge = MarginsOf(canvas);
  const double width =
      canvas.width_em() - edge.left - edge.right - (columns - 1) * edge.between_columns;
  const double height = canvas.height_em() - edge.top - edge.bottom - (rows - 1) * between_rows_em;
  return {std::max(1.0, width / columns), std::max(1.0, height / rows)};
}

std::string StartMultiplot(const PlotData& data, const std::string& title, int rows, int columns,
                           double between_rows_em) {
  const Margins edge = MarginsOf(data.canvas);
  const double width = data.canvas.width_em(), height = data.canvas.height_em();
  std::ostringstream script;
  script << "set multiplot layout " << rows << "," << columns << " title " << TitleText(data, title)
         << " margins screen " << edge.left / width << "," << 1.0 - edge.right / width << ","
         << edge.bottom / height << "," << 1.0 - edge.top / height << " spacing screen "
         << edge.between_columns / width << "," << between_rows_em / height << "\n";
  return script.str();
}

std::string StartPanels(const PlotData& data, const std::string& title, int rows, int columns) {
  const double length_em = PanelSize_em(data.canvas, rows, columns).x();
  std::ostringstream script;
  script << "set xrange [" << data.start_s << ":" << data.end_s << "]\nset xtics "
         << TimeStep_s(data.end_s - data.start_s, length_em) << "\n";
  int object = 1;
  for (const Stretch& push : data.pushes) {
    if (push.end_s <= data.start_s || push.start_s >= data.end_s) continue;
    script << "set object " << object++ << " rectangle from "
           << std::max(push.start_s, data.start_s) << ", graph 0 to "
           << std::min(push.end_s, data.end_s) << ", graph 1 behind fillcolor rgb \""
           << palette::kPush << "\" fillstyle transparent solid 0.16 noborder  # push\n";
  }
  return script.str() + StartMultiplot(data, title, rows, columns);
}

double TimeStep_s(double duration_s, double length_em) {
  return NiceStep(duration_s * kTicX_em / length_em);
}

std::string AxisLines(const std::string& axis, Span span, double length_em) {
  if (span.is_empty()) span = {0.0, 1.0};
  double margin = kAxisMargin * span.length();
  const double magnitude = std::max(std::abs(span.min), std::abs(span.max));
  if (span.length() < std::max(kLeastRange, kLeastShare * magnitude)) {
    margin = magnitude < kLeastRange ? 1.0 : kStillRange * magnitude;
  }
  const double from = span.min - margin, to = span.max + margin;
  const double room_em = axis == "x" ? kTicX_em : kTicY_em;
  const double tics = std::clamp(length_em / room_em, 2.0, 8.0);
  return "set " + axis + "range [" + Number(from) + ":" + Number(to) + "]\nset " + axis + "tics " +
         Number(NiceStep((to - from) / tics)) + "\n";
}

std::string YAxis(const PlotData& data, int rows, const std::vector<std::string>& curves,
                  bool has_zero) {
  Span span;
  for (const std::string& curve : curves) span.Include(data.curves.YOf(curve));
  if (has_zero) span.Include(0.0);
  return AxisLines("y", span, PanelSize_em(data.canvas, rows, 1).y());
}

std::string Curve(const PlotData& data, const std::string& name, const std::string& style,
                  const std::string& title) {
  return data.curves.Macro(name) + " with lines " + style +
         (title.empty() ? " notitle" : " title " + GnuplotText(title));
}

std::string LineStyle(const std::string& color, const std::string& more) {
  return "linecolor rgb \"" + color + "\" " + more;
}

std::string FaintStyle(const std::string& color, const std::string& more) {
  return LineStyle("#80" + color.substr(1), more);  // gnuplot's alpha comes first: 0 is opaque
}

std::string ZeroLine() {
  return "0 with lines " + LineStyle(palette::kGrid, "linewidth 0.5 notitle");
}

std::string PushKey(const PlotData& data) {
  if (data.pushes.empty()) return "keyentry with points pointtype 0 title ' '";
  std::string key = "keyentry with boxes fillcolor rgb \"";
  key += palette::kPush;
  key += "\" fillstyle transparent solid 0.16 noborder title 'push'";
  return key;
}

std::string DataBlock(const std::string& name, const std::string& rows, int columns) {
  std::string block = "$" + name + " << END\n" + rows;
  if (rows.empty()) {
    for (int i = 0; i < columns; ++i) block += i == 0 ? "NaN" : " NaN";
    block += "\n";
  }
  return block + "END\n";
}

}  // namespace sidestep::plot
