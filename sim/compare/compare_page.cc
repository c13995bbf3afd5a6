// SPDX-License-Identifier: BSD-3-Clause
#include "sim/compare/compare_page.h"

#include <cmath>
#include <cstdio>

#include "sim/compare/overlay_plots.h"
#include "sim/record/output_file.h"
#include "sim/record/run_reader.h"
#include "sim/report/html.h"
#include "sim/report/inline_svg.h"
#include "sim/report/report_style.h"

namespace sidestep {
namespace {

using report::Escaped;
using Rows = std::vector<std::vector<std::string>>;

std::string Figure(const char* format, double value) {
  char text[48];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

std::string TableCard(const std::string& title, const std::vector<std::string>& headings,
                      const Rows& rows) {
  const std::string none = "<p>none</p>";
  return "<h3>" + title + "</h3>\n<div class=\"card scroll\">" +
         (rows.empty() ? none : report::Table(headings, rows)) + "</div>\n";
}

std::string SettingsCard(const RunComparison& comparison) {
  Rows rows;
  for (const SettingDifference& one : comparison.settings) {
    rows.push_back({Escaped(one.key), Escaped(one.first), Escaped(one.second)});
  }
  return TableCard("Settings that differ", {"key", "A", "B"}, rows);
}

std::string MetricsCard(const RunComparison& comparison) {
  Rows rows;
  for (const MetricPair& one : comparison.metrics) {
    const double change = one.second - one.first;
    const bool is_same =
        one.first == one.second || (std::isnan(one.first) && std::isnan(one.second));
    if (is_same) continue;
    const bool has_share = std::isfinite(change) && one.first != 0.0;
    rows.push_back({Escaped(one.name), Figure("%.6g", one.first), Figure("%.6g", one.second),
                    std::isfinite(change) ? Figure("%+.4g", change) : "",
                    has_share ? Figure("%+.1f %%", 100.0 * change / std::abs(one.first)) : ""});
  }
  return TableCard("Metrics that differ", {"metric", "A", "B", "change", "of A"}, rows);
}

std::string Badge(const std::string& verdict) {
  return "<span class=\"badge " + Escaped(verdict) + "\">" + Escaped(verdict) + "</span>";
}

}  // namespace

std::string ComparePage(const RunComparison& comparison, const std::string& first,
                        const std::string& second,
                        const std::vector<std::pair<std::string, std::string>>& plots) {
  std::string page =
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width\">\n<title>Two runs compared</title>\n"
      "<style>" +
      std::string(report::StyleSheet()) +
      "main > h3 { margin: 28px 0 10px; }\n</style>\n</head>\n<body>\n<main>\n<header>\n<h1>Two "
      "runs compared</h1>\n<p>A, solid: " +
      Escaped(first) + " " + Badge(comparison.first_verdict) +
      "</p>\n<p>B, dashed: " + Escaped(second) + " " + Badge(comparison.second_verdict) +
      "</p>\n<p>" + Escaped(DivergenceText(comparison)) + "</p>\n<p>" +
      Escaped(StatesText(comparison)) + "</p>\n</header>\n";
  if (!plots.empty()) page += "<h3>Both in the same axes</h3>\n<div class=\"plots\">\n";
  for (std::size_t i = 0; i < plots.size(); ++i) {
    page += "<figure>" +
            report::InlineSvg(plots[i].second, "plot-" + std::to_string(i) + "-", plots[i].first) +
            "</figure>\n";
  }
  if (!plots.empty()) page += "</div>\n";
  return page + SettingsCard(comparison) + MetricsCard(comparison) + "</main>\n</body>\n</html>\n";
}

void WriteComparison(const RunComparison& comparison, const std::filesystem::path& first,
                     const std::filesystem::path& second, const std::filesystem::path& folder) {
  PlotOverlay(first, second, folder);
  std::vector<std::pair<std::string, std::string>> plots;
  for (const OverlayPlot& one : OverlayPlots()) {
    plots.emplace_back(one.label, ReadWholeFile(folder / (one.name + ".svg")));
  }
  WriteWholeFile(folder / "compare.html", ComparePage(comparison, first, second, plots));
}

}  // namespace sidestep
