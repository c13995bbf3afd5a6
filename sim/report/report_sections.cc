// SPDX-License-Identifier: BSD-3-Clause
#include "sim/report/report_sections.h"

#include <algorithm>
#include <cmath>

#include "sim/report/html.h"
#include "sim/report/inline_svg.h"

namespace sidestep::report {
namespace {

using Rows = std::vector<std::vector<std::string>>;

std::string Badge(VerdictClass verdict) {
  const std::string name(EnumName(verdict));
  return "<span class=\"badge " + name + "\">" + name + "</span>";
}

std::string ReasonText(const ReasonSummary& reason) {
  std::string text = "<b>" + Escaped(reason.kind) + "</b> " + Escaped(reason.text);
  if (reason.time_s) text += " at " + Readable(*reason.time_s) + " s";
  return text;
}

// What was asked of a metric: "no", "0.01 to 0.1", "at most 0.1".
std::string Asked(const ExpectationSummary& expectation) {
  const std::optional<double>& min = expectation.min;
  const std::optional<double>& max = expectation.max;
  if (expectation.is) return Readable(*expectation.is);
  if (!min && !max) return "–";
  if (!max) return "at least " + Readable(*min);
  if (!min) return "at most " + Readable(*max);
  return *min == *max ? Readable(*min) : Readable(*min) + " to " + Readable(*max);
}

std::string Expectations(const RunEvidence& run) {
  Rows rows;
  for (const ExpectationSummary& expectation : run.summary.expectations) {
    rows.push_back({"<code>" + Escaped(expectation.metric) + "</code>", Asked(expectation),
                    Readable(expectation.measured),
                    expectation.pass ? "<span class=\"met\">met</span>"
                                     : "<span class=\"missed\">missed</span>"});
  }
  if (rows.empty()) return "<p>The scenario states no expectation.</p>\n";
  return Table({"metric", "expected", "measured", ""}, rows);
}

std::string Pushes(const RunEvidence& run) {
  Rows rows;
  for (const PushSummary& push : run.summary.pushes) {
    rows.push_back({Escaped(push.body), Readable(push.start_s), Readable(push.duration_s),
                    Readable(push.impulse_Ns), Readable(push.impulse_per_mass_mps)});
  }
  if (rows.empty()) return "<p>No push.</p>\n";
  return Table({"body", "start (s)", "duration (s)", "impulse J (N·s)", "J/m (m/s)"}, rows);
}

std::string SolveTimes(const RunEvidence& run) {
  const StageTimes& times = run.summary.solve_time;
  return Table({}, {{"p50 (ms)", Readable(times.p50_ms)},
                    {"p99 (ms)", Readable(times.p99_ms)},
                    {"max (ms)", Readable(times.max_ms)},
                    {"deadline (ms)", Readable(times.deadline_ms)},
                    {"solves", std::to_string(times.count)},
                    {"deadline misses", std::to_string(times.misses)},
                    {"real-time factor of the run", Readable(run.summary.real_time_factor)}});
}

std::string Metrics(const RunEvidence& run) {
  Rows rows;
  for (const auto& [name, value] : run.summary.metrics) {
    rows.push_back({"<code>" + Escaped(name) + "</code>", Readable(value)});
  }
  return rows.empty() ? "<p>None.</p>\n" : Table({}, rows);
}

std::string Settings(const RunEvidence& run) {
  Rows rows;
  for (const auto& [key, value] : run.settings) {
    rows.push_back({"<code>" + Escaped(key) + "</code>", Escaped(value)});
  }
  for (const auto& [name, version] : run.summary.versions) {
    rows.push_back({Escaped(name), Escaped(version)});
  }
  return Table({}, rows);
}

std::string Command(const RunEvidence& run) {
  std::string command;
  for (const std::string& argument : run.summary.command) {
    command += (command.empty() ? "" : " ") + Escaped(argument);
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
  for (const PushSummary& push : run.summary.pushes) {
    largest = std::fmax(largest, push.impulse_per_mass_mps);  // passes over a NaN
  }
  return largest;
}

std::string MetricOf(const RunEvidence& run, const std::string& name) {
  const auto found = run.summary.metrics.find(name);
  return Readable(found == run.summary.metrics.end() ? MetricValue(kNotTold) : found->second);
}

}  // namespace

std::string ComparisonSection(const std::vector<RunEvidence>& runs) {
  Rows rows;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const RunEvidence& run = runs[i];
    std::string reasons;
    for (const ReasonSummary& reason : run.summary.reasons) {
      reasons += (reasons.empty() ? "" : "<br>") + ReasonText(reason);
    }
    const StageTimes& times = run.summary.solve_time;
    rows.push_back(
        {"<a href=\"#run" + std::to_string(i) + "\">" + Escaped(run.summary.name) + "</a>",
         Badge(run.summary.verdict), Readable(LargestPush(run)),
         MetricOf(run, "mean_step_adjustment_m"), Readable(times.p50_ms), Readable(times.p99_ms),
         Readable(times.max_ms), reasons});
  }
  const auto passed = std::count_if(runs.begin(), runs.end(), [](const RunEvidence& run) {
    return run.summary.verdict == VerdictClass::kPass;
  });
  return "<header><h1>" + std::to_string(runs.size()) + " runs, " + std::to_string(passed) +
         " passed</h1></header>\n" +
         Table({"scenario", "verdict", "largest J/m (m/s)", "mean step adjustment (m)",
                "solve p50 (ms)", "p99 (ms)", "max (ms)", "reasons"},
               rows);
}

std::string RunSection(const RunEvidence& run, std::size_t index) {
  const std::string anchor = "run" + std::to_string(index);
  std::string html = "<article id=\"" + anchor + "\">\n<header><h2>" + Escaped(run.summary.name) +
                     " " + Badge(run.summary.verdict) + "</h2>\n";
  if (!run.description.empty()) html += "<p>" + Escaped(run.description) + "</p>\n";
  if (!run.summary.reasons.empty()) {
    html += "<ul class=\"reasons\">";
    for (const ReasonSummary& reason : run.summary.reasons) {
      html += "<li>" + ReasonText(reason) + "</li>";
    }
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
