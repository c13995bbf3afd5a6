// SPDX-License-Identifier: BSD-3-Clause
#include "sim/check/outcome.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <exception>
#include <nlohmann/json.hpp>

#include "sim/record/run_summary.h"

namespace sidestep {
namespace {

constexpr std::size_t kErrorBytes = 2000;  ///< How much of a stderr is kept.

std::string Number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

std::string Value(double value) { return std::isfinite(value) ? Number(value) : "null"; }

std::string Value(bool value) { return value ? "true" : "false"; }

// "FALL at 1.204 s: base too low".
std::string ReasonText(const ReasonSummary& reason) {
  std::string text = reason.kind;
  if (reason.time_s) {
    char time[32];
    std::snprintf(time, sizeof time, " at %.3f s", *reason.time_s);
    text += time;
  }
  return reason.text.empty() ? text : text + ": " + reason.text;
}

// "mean_step_adjustment_m = 0.043 (min 0.01, max 0.1)", with "missed" when it does not hold.
std::string MeasuredText(const ExpectationSummary& expectation) {
  std::string bounds;
  const auto add_bound = [&](const char* name, const auto& bound) {
    if (!bound) return;
    bounds += (bounds.empty() ? "" : ", ") + std::string(name) + " " + Value(*bound);
  };
  add_bound("min", expectation.min);
  add_bound("max", expectation.max);
  add_bound("is", expectation.is);
  std::string text = expectation.metric + " = ";
  text += std::visit([](auto value) { return Value(value); }, expectation.measured);
  if (!bounds.empty()) text += " (" + bounds + ")";
  if (!expectation.pass) text += " missed";
  return text;
}

std::string Tail(const std::string& text) {
  const std::size_t end = text.find_last_not_of(" \n\r\t");
  if (end == std::string::npos) return {};
  const std::string kept = text.substr(0, end + 1);
  return kept.size() <= kErrorBytes ? kept : "..." + kept.substr(kept.size() - kErrorBytes);
}

std::string LastLine(const std::string& text) {
  const std::size_t line_end = text.rfind('\n');
  return line_end == std::string::npos ? text : text.substr(line_end + 1);
}

std::string Ending(int exit_code) {
  if (exit_code <= ProcessResult::kSignalBase)
    return "the run ended with exit code " + std::to_string(exit_code);
  const int signal = exit_code - ProcessResult::kSignalBase;
  const char* name = strsignal(signal);
  return "the run was ended by signal " + std::to_string(signal) +
         (name == nullptr ? "" : " (" + std::string(name) + ")");
}

void ReadInto(const RunSummary& summary, Outcome* outcome) {
  outcome->verdict = summary.verdict;
  for (const ReasonSummary& reason : summary.reasons) {
    outcome->reasons.push_back(ReasonText(reason));
  }
  for (const ExpectationSummary& expectation : summary.expectations) {
    outcome->measured.push_back(MeasuredText(expectation));
  }
  const double factor = summary.cpu_real_time_factor;
  outcome->real_time_factor = std::isfinite(factor) ? factor : 0.0;
}

}  // namespace

Outcome ReadOutcome(const std::string& name, const std::filesystem::path& file,
                    const std::filesystem::path& run_dir, const ProcessResult& process,
                    double wall_s) {
  Outcome outcome;
  outcome.name = name;
  outcome.file = file;
  outcome.wall_s = wall_s;
  outcome.error_output = Tail(process.err);
  std::string problem;
  try {
    ReadInto(ReadSummary(run_dir), &outcome);
    if (ExitCodeOf(outcome.verdict) != process.exit_code) {
      problem = Ending(process.exit_code);
      if (outcome.verdict != VerdictClass::kInvalid) {
        problem += " but its summary says " + std::string(EnumName(outcome.verdict));
      }
    }
  } catch (const std::exception& error) {
    // The summary of a run that died is no evidence; what the process said is.
    problem = Ending(process.exit_code) + " and left no whole summary";
    if (outcome.error_output.empty()) problem += std::string(" (") + error.what() + ")";
  }
  if (problem.empty()) return outcome;
  outcome.verdict = VerdictClass::kInvalid;
  if (!outcome.error_output.empty()) problem += ": " + LastLine(outcome.error_output);
  outcome.reasons.insert(outcome.reasons.begin(), "ERROR: " + problem);
  return outcome;
}

std::string OutcomesJson(const std::vector<Outcome>& outcomes) {
  auto list = nlohmann::ordered_json::array();
  for (const Outcome& outcome : outcomes) {
    list.push_back({{"name", outcome.name},
                    {"robot", outcome.robot},
                    {"file", outcome.file.string()},
                    {"run", outcome.run_dir.string()},
                    {"verdict", EnumName(outcome.verdict)},
                    {"reasons", outcome.reasons},
                    {"measured", outcome.measured},
                    {"wall_s", outcome.wall_s}});
  }
  return list.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

int ExitCodeOf(const std::vector<Outcome>& outcomes) {
  int worst = 0;
  for (const Outcome& outcome : outcomes) {
    worst = std::max(worst, ExitCodeOf(outcome.verdict));
  }
  return worst;
}

}  // namespace sidestep
