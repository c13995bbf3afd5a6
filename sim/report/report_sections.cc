// SPDX-License-Identifier: BSD-3-Clause
#include "sim/report/report_sections.h"

#include <algorithm>

#include "sim/report/html.h"
#include "sim/report/inline_svg.h"

namespace sidestep::report {
namespace {

using Rows = std::vector<std::vector<std::string>>;

std::string Show(const nlohmann::json& value) { return Escaped(Readable(value)); }

std::string Badge(const std::string& verdict) {
  const bool is_known = verdict == "PASS" || verdict == "FAIL";
  return "<span class=\"badge " + std::string(is_known ? verdict : "INVALID") + "\">" +
         Escaped(verdict) + "</span>";
}

std::string ReasonText(const nlohmann::json& reason) {
  std::string text = "<b>" + Show(Get(reason, "class")) + "</b> " + Show(Get(reason, "text"));
  const nlohmann::json time_s = Get(reason, "time_s");
  if (time_s.is_number()) text += " at " + Show(time_s) + " s";
  return text;
}

// What was asked of a metric: "no", "0.01 to 0.1", "at most 0.1".
std::string Asked(const nlohmann::json& expectation) {
  const nlohmann::json is = Get(expectation, "is");
  const nlohmann::json min = Get(expectation, "min");
  const nlohmann::json max = Get(expectation, "max");
  if (!is.is_null()) return Show(is);
  if (min.is_null() && max.is_null()) return "–";
  if (max.is_null()) return "at least " + Show(min);
  if (min.is_null()) return "at most " + Show(max);
  return min == max ? Show(min) : Show(min) + " to " + Show(max);
}

std::string Expectations(const RunEvidence& run) {
  Rows rows;
  for (const nlohmann::json& expectation : GetList(run.summary, "expectations")) {
    const nlohmann::json pass = Get(expectation, "pass");
    const bool is_met = pass.is_boolean() && pass.get<bool>();
    rows.push_back(
        {"<code>" + Show(Get(expectation, "metric")) + "</code>", Asked(expectation),
         Show(Get(expectation, "measured")),
         is_met ? "<span class=\"met\">met</span>" : "<span class=\"missed\">missed</span>"});
  }
  if (rows.empty()) return "<p>The scenario states no expectation.</p>\n";
  return Table({"metric", "expected", "measured", ""}, rows);
}

std::string Pushes(const RunEvidence& run) {
  Rows rows;
  for (const nlohmann::json& push : GetList(run.summary, "pushes")) {
    rows.push_back({Show(Get(push, "body")), Show(Get(push, "start_s")),
                    Show(Get(push, "duration_s")), Show(Get(push, "impulse_Ns")),
                    Show(Get(push, "impulse_per_mass_mps"))});
  }
  if (rows.empty()) return "<p>No push.</p>\n";
  return Table({"body", "start (s)", "duration (s)", "impulse J (N·s)", "J/m (m/s)"}, rows);
}

std::string SolveTimes(const RunEvidence& run) {
  const nlohmann::json times = Get(run.summary, "solve_time_ms");
  if (!times.is_object()) return "<p>No solve was timed.</p>\n";
  Rows rows;
  for (const char* key : {"p50", "p99", "max", "deadline"}) {
    rows.push_back({std::string(key) + " (ms)", Show(Get(times, key))});
  }
  rows.push_back({"solves", Show(Get(times, "count"))});
  rows.push_back({"deadline misses", Show(Get(times, "misses"))});
  rows.push_back({"real-time factor of the run", Show(Get(run.summary, "real_time_factor"))});
  return Table({}, rows);
}

std::string Metrics(const RunEvidence& run) {
  const nlohmann::json metrics = Get(run.summary, "metrics");
  Rows rows;
  if (metrics.is_object()) {
    for (const auto& [name, value] : metrics.items()) {
      rows.push_back({"<code>" + Escaped(name) + "</code>", Show(value)});
    }
  }
  return rows.empty() ? "<p>None.</p>\n" : Table({}, rows);
}

std::string Settings(const RunEvidence& run) {
  Rows rows;
  for (const auto& [key, value] : run.settings) {
    rows.push_back({"<code>" + Escaped(key) + "</code>", Escaped(value)});
  }
  const nlohmann::json versions = Get(run.summary, "versions");
  if (versions.is_object()) {
    for (const auto& [name, value] : versions.items()) {
      rows.push_back({Escaped(name), Show(value)});
    }
  }
  return Table({}, rows);
}

std::string Command(const RunEvidence& run) {
  std::string command;
  for (const nlohmann::json& argument : GetList(run.summary, "command")) {
    command += (command.empty() ? "" : " ") + Show(argument);
  }
  return command.empty() ? "" : "<p class=\"command\"><code>" + command + "</code></p>\n";
}

std::string Plots(const RunEvidence& run, const std::string& anchor) {
  std::string html;
  for (const auto& [name, svg] : run.plots) {
    std::string label = name;
    std::replace(label.begin(), label.end(), '_', ' ');
    std::string id = anchor + "-" + name + "-";
    std::replace(id.begin(), id.end(), '_', '-');
    html += "<figure>" + InlineSvg(svg, id, label) + "</figure>\n";
  }
  return html.empty() ? "" : "<h3>Plots</h3>\n<div class=\"plots\">\n" + html + "</div>\n";
}

std::string Card(const std::string& title, const std::string& content) {
  return "<section class=\"card\"><h3>" + title + "</h3>\n" + content + "</section>\n";
}

double LargestPush(const RunEvidence& run) {
  double largest = 0.0;
  for (const nlohmann::json& push : GetList(run.summary, "pushes")) {
    const nlohmann::json value = Get(push, "impulse_per_mass_mps");
    if (value.is_number()) largest = std::max(largest, value.get<double>());
  }
  return largest;
}

}  // namespace

std::string ComparisonSection(const std::vector<RunEvidence>& runs) {
  Rows rows;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const RunEvidence& run = runs[i];
    std::string reasons;
    for (const nlohmann::json& reason : GetList(run.summary, "reasons")) {
      reasons += (reasons.empty() ? "" : "<br>") + ReasonText(reason);
    }
    const nlohmann::json times = Get(run.summary, "solve_time_ms");
    const nlohmann::json metrics = Get(run.summary, "metrics");
    rows.push_back({"<a href=\"#run" + std::to_string(i) + "\">" + Escaped(run.name) + "</a>",
                    Badge(run.verdict), Show(LargestPush(run)),
                    Show(Get(metrics, "mean_step_adjustment_m")), Show(Get(times, "p50")),
                    Show(Get(times, "p99")), Show(Get(times, "max")), reasons});
  }
  const auto passed = std::count_if(runs.begin(), runs.end(),
                                    [](const RunEvidence& run) { return run.verdict == "PASS"; });
  return "<header><h1>" + std::to_string(runs.size()) + " runs, " + std::to_string(passed) +
         " passed</h1></header>\n" +
         Table({"scenario", "verdict", "largest J/m (m/s)", "mean step adjustment (m)",
                "solve p50 (ms)", "p99 (ms)", "max (ms)", "reasons"},
               rows);
}

std::string RunSection(const RunEvidence& run, std::size_t index) {
  const std::string anchor = "run" + std::to_string(index);
  std::string html = "<article id=\"" + anchor + "\">\n<header><h2>" + Escaped(run.name) + " " +
                     Badge(run.verdict) + "</h2>\n";
  if (!run.description.empty()) html += "<p>" + Escaped(run.description) + "</p>\n";
  const nlohmann::json reasons = GetList(run.summary, "reasons");
  if (!reasons.empty()) {
    html += "<ul class=\"reasons\">";
    for (const nlohmann::json& reason : reasons) html += "<li>" + ReasonText(reason) + "</li>";
    html += "</ul>\n";
  }
  html += "</header>\n";
  if (!run.video.empty()) {
    html += "<video controls loop muted playsinline src=\"data:video/mp4;base64," +
            Base64(run.video) + "\"></video>\n";
  }
  html += "<div class=\"cards\">\n" + Card("Expectations", Expectations(run)) +
          Card("Pushes", Pushes(run)) + Card("MPC solve time", SolveTimes(run)) +
          Card("Metrics", Metrics(run)) + Card("Settings", Settings(run)) + "</div>\n";
  html += Plots(run, anchor);
  html += "<h3>Run it again</h3>\n" + Command(run) +
          "<details><summary>The scenario as it was resolved</summary>\n<pre>" +
          Escaped(run.scenario_yaml) + "</pre></details>\n";
  return html + "</article>\n";
}

}  // namespace sidestep::report
