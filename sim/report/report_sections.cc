// SPDX-License-Identifier: BSD-3-Clause
#include "sim/report/report_sections.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>

#include "sim/report/html.h"
#include "sim/report/inline_svg.h"
#include "sim/verdict/metrics.h"

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

// Where a push points, seen from above with ahead upwards.
std::string Arrow(double direction_rad) {
  if (!std::isfinite(direction_rad)) return "–";
  const double angle_deg = direction_rad * 180.0 / std::numbers::pi;
  const std::string degrees = Readable(std::round(angle_deg)) + "°";
  return "<svg class=\"arrow\" viewBox=\"-12 -12 24 24\" role=\"img\" aria-label=\"" + degrees +
         "\"><path transform=\"rotate(" + Readable(-angle_deg) +
         ")\" d=\"M0 10V-8M-5 -3L0 -9L5 -3\" fill=\"none\" stroke=\"currentColor\" "
         "stroke-width=\"2.4\"/></svg> " +
         degrees;
}

std::string OutcomeOf(const PushSummary& push) {
  if (push.outcome.empty()) return push.recovered ? "recovered" : "not recovered";
  const char* style = push.outcome == "RECOVERED" ? "met" : "missed";
  std::string words = push.outcome;
  std::replace(words.begin(), words.end(), '_', ' ');
  std::string text = std::string("<span class=\"") + style + "\">" + Escaped(words) + "</span>";
  if (push.recovered) text += " after " + Readable(push.recovery_time_s) + " s";
  return text;
}

std::string Pushes(const RunEvidence& run) {
  Rows rows;
  for (const PushSummary& push : run.summary.pushes) {
    rows.push_back({Escaped(push.body), OutcomeOf(push), Readable(push.force_N),
                    Arrow(push.direction_rad), Readable(push.start_s), Readable(push.duration_s),
                    Readable(push.phase), Readable(push.impulse_Ns),
                    Readable(push.impulse_per_mass_mps), std::to_string(push.steps_taken),
                    Readable(push.max_step_adjustment_m)});
  }
  if (rows.empty()) return "<p>No push.</p>\n";
  return Table(
      {"body", "outcome", "force (N)", "direction", "start (s)", "duration (s)",
       "phase of the stride", "impulse J (N·s)", "J/m (N·s/kg)", "steps", "largest adjustment (m)"},
      rows);
}

std::string SolveTimes(const RunEvidence& run) {
  const StageTimes& wall = run.summary.solve_time;
  const StageTimes& cpu = run.summary.solve_cpu;
  return Table({"of " + std::to_string(wall.count) + " solves", "processor", "on the wall"},
               {{"p50 (ms)", Readable(cpu.p50_ms), Readable(wall.p50_ms)},
                {"p99 (ms)", Readable(cpu.p99_ms), Readable(wall.p99_ms)},
                {"max (ms)", Readable(cpu.max_ms), Readable(wall.max_ms)},
                {"deadline (ms)", Readable(cpu.deadline_ms), Readable(wall.deadline_ms)},
                {"deadline misses", std::to_string(cpu.misses), std::to_string(wall.misses)},
                {"the run, times real time", Readable(run.summary.cpu_real_time_factor),
                 Readable(run.summary.real_time_factor)}});
}

std::string Metrics(const RunEvidence& run) {
  Rows rows;
  for (const auto& [name, value] : run.summary.metrics) {
    const MetricInfo* info = FindMetric(name);
    rows.push_back({"<code>" + Escaped(name) + "</code>", Readable(value),
                    info == nullptr ? "" : Escaped(info->meaning)});
  }
  return rows.empty() ? "<p>None.</p>\n" : Table({"metric", "value", "meaning"}, rows);
}

std::string Settings(const RunEvidence& run) {
  Rows rows;
  for (const auto& [key, value] : run.settings) {
    rows.push_back({"<code>" + Escaped(key) + "</code>", Escaped(value)});
  }
  for (const auto& [name, version] : run.summary.versions) {
    rows.push_back({Escaped(name), Escaped(version)});
  }
  for (const std::string& text : run.summary.overrides) {
    rows.push_back({"override", Escaped(text)});
  }
  if (!run.summary.scenario_hash.empty()) {
    rows.push_back({"hash of the scenario", Escaped(run.summary.scenario_hash)});
  }
  if (!run.summary.model_hash.empty()) {
    rows.push_back({"hash of the model", Escaped(run.summary.model_hash)});
  }
  return Table({}, rows);
}

// A word as a POSIX shell reads it back.
std::string ShellWord(const std::string& word) {
  constexpr std::string_view kPlain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./:=,+@%";
  if (!word.empty() && word.find_first_not_of(kPlain) == std::string::npos) return word;
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? "'\\''" : std::string(1, c);
  return quoted + "'";
}

std::string Command(const RunEvidence& run) {
  std::string command;
  for (const std::string& argument : run.summary.command) {
    command += (command.empty() ? "" : " ") + Escaped(ShellWord(argument));
  }
  return command.empty() ? "" : "<pre class=\"command\">" + command + "</pre>\n";
}

// The plot that explains best what happened: steps from above, or whatever comes first.
std::string MainPlot(const RunEvidence& run) {
  const auto found = std::find_if(run.plots.begin(), run.plots.end(),
                                  [](const auto& plot) { return plot.first == "top_view"; });
  if (found != run.plots.end()) return found->first;
  return run.plots.empty() ? "" : run.plots.front().first;
}

std::string Plot(const std::string& name, const std::string& svg, const std::string& anchor) {
  std::string label = name;
  std::replace(label.begin(), label.end(), '_', ' ');
  std::string id = anchor + "-" + name + "-";
  std::replace(id.begin(), id.end(), '_', '-');
  const std::string drawing = InlineSvg(svg, id, label);
  return "<figure>" +
         (drawing.empty() ? "<p>" + Escaped(label) + ".svg is no plot of gnuplot's.</p>"
                          : drawing) +
         "</figure>\n";
}

// One plot, or all but that.
std::string Plots(const RunEvidence& run, const std::string& anchor, bool is_main) {
  const std::string main = MainPlot(run);
  std::string html;
  for (const auto& [name, svg] : run.plots) {
    if ((name == main) == is_main) html += Plot(name, svg, anchor);
  }
  return html.empty() ? "" : "<div class=\"plots\">\n" + html + "</div>\n";
}

std::string Folded(const std::string& title, const std::string& content) {
  if (content.empty()) return "";
  return "<details><summary>" + title + "</summary>\n" + content + "</details>\n";
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
  if (run.summary.log == LogDetail::kNone) {
    html += "<p>Recorded with <code>--log none</code>: no plots and no film.</p>\n";
  }
  if (!run.video.empty()) {
    html += "<video controls loop muted playsinline src=\"data:video/mp4;base64," +
            Base64(run.video) + "\"></video>\n";
  }
  html += Plots(run, anchor, true) + "<div class=\"cards\">\n" + Card("Pushes", Pushes(run)) +
          Card("Expectations", Expectations(run)) + "</div>\n";
  html +=
      Folded("All plots", Plots(run, anchor, false)) + Folded("MPC solve time", SolveTimes(run)) +
      Folded("Metrics", Metrics(run)) + Folded("Settings", Settings(run)) +
      Folded("The scenario as it was resolved", "<pre>" + Escaped(run.scenario_yaml) + "</pre>");
  html += "<h3>Run it again</h3>\n" + Command(run);
  return html + "</article>\n";
}

}  // namespace sidestep::report
