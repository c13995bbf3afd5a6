// SPDX-License-Identifier: BSD-3-Clause
#include "sim/check/outcome.h"

#include <algorithm>
#include <cstring>
#include <exception>
#include <nlohmann/json.hpp>

#include "sim/record/run_reader.h"

namespace sidestep {
namespace {

using Json = nlohmann::json;

constexpr std::size_t kErrorBytes = 2000;  ///< How much of a stderr is kept.
constexpr int kSignalBase = 128;           ///< ProcessResult's exit code of a signal: 128 + n.

std::string Number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

std::string Value(const Json& value) {
  return value.is_number() ? Number(value.get<double>()) : value.dump();
}

// "FALL at 1.204 s: base too low".
std::string ReasonText(const Json& reason) {
  std::string text = reason.value("class", "ERROR");
  if (reason.contains("time_s") && reason["time_s"].is_number()) {
    char time[32];
    std::snprintf(time, sizeof time, " at %.3f s", reason["time_s"].get<double>());
    text += time;
  }
  const std::string what = reason.value("text", "");
  return what.empty() ? text : text + ": " + what;
}

// "mean_step_adjustment_m = 0.043 (min 0.01, max 0.1)", with "missed" when it does not hold.
std::string MeasuredText(const Json& expectation) {
  std::string bounds;
  for (const char* key : {"min", "max", "is"}) {
    if (!expectation.contains(key) || expectation[key].is_null()) continue;
    bounds += (bounds.empty() ? "" : ", ") + std::string(key) + " " + Value(expectation[key]);
  }
  std::string text = expectation.value("metric", "?") + " = ";
  text += expectation.contains("measured") ? Value(expectation["measured"]) : "?";
  if (!bounds.empty()) text += " (" + bounds + ")";
  if (!expectation.value("pass", true)) text += " missed";
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
  if (exit_code <= kSignalBase) return "the run ended with exit code " + std::to_string(exit_code);
  const int signal = exit_code - kSignalBase;
  const char* name = strsignal(signal);
  return "the run was ended by signal " + std::to_string(signal) +
         (name == nullptr ? "" : " (" + std::string(name) + ")");
}

RunClass ClassOf(const std::string& verdict) {
  if (verdict == "PASS") return RunClass::kPass;
  if (verdict == "FAIL") return RunClass::kFail;
  return RunClass::kInvalid;
}

void ReadInto(const Json& summary, Outcome* outcome) {
  outcome->run_class = ClassOf(summary.at("verdict").get<std::string>());
  for (const Json& reason : summary.at("reasons")) {
    outcome->reasons.push_back(ReasonText(reason));
  }
  for (const Json& expectation : summary.at("expectations")) {
    outcome->measured.push_back(MeasuredText(expectation));
  }
  const Json factor = summary.value("real_time_factor", Json());
  outcome->real_time_factor = factor.is_number() ? factor.get<double>() : 0.0;
}

}  // namespace

const char* ToString(RunClass run_class) {
  switch (run_class) {
    case RunClass::kPass:
      return "PASS";
    case RunClass::kFail:
      return "FAIL";
    case RunClass::kInvalid:
      break;
  }
  return "INVALID";
}

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
    if (static_cast<int>(outcome.run_class) != process.exit_code) {
      problem = Ending(process.exit_code) + " but its summary says " + ToString(outcome.run_class);
    }
  } catch (const std::exception& error) {
    // The summary of a run that died is no evidence; what the process said is.
    problem = Ending(process.exit_code) + " and left no whole summary";
    if (outcome.error_output.empty()) problem += std::string(" (") + error.what() + ")";
  }
  if (problem.empty()) return outcome;
  outcome.run_class = RunClass::kInvalid;
  if (!outcome.error_output.empty()) problem += ": " + LastLine(outcome.error_output);
  outcome.reasons.insert(outcome.reasons.begin(), "ERROR: " + problem);
  return outcome;
}

int ExitCodeOf(const std::vector<Outcome>& outcomes) {
  int worst = 0;
  for (const Outcome& outcome : outcomes) {
    worst = std::max(worst, static_cast<int>(outcome.run_class));
  }
  return worst;
}

}  // namespace sidestep
