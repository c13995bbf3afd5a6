// SPDX-License-Identifier: BSD-3-Clause
#include "sim/render/outcome.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "sim/render/caption_colors.h"

namespace sidestep::render {
namespace {

constexpr double kVerdictShown_s = 1.0;  // as long as in a run's own video
constexpr double kTold_s = 0.05;         // shorter than this reads as 0.0 s

std::string Seconds(double time_s) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f s", time_s);
  return text;
}

double NumberOr(const RunSummary& summary, const char* metric, double fallback) {
  const auto found = summary.metrics.find(metric);
  if (found == summary.metrics.end()) return fallback;
  const double* value = std::get_if<double>(&found->second);
  return value != nullptr && std::isfinite(*value) ? *value : fallback;
}

Outcome Fallen(const RunSummary& summary, double last_s) {
  const double fall_s = NumberOr(summary, "fall_time_s", last_s);
  const bool is_expected = summary.verdict == VerdictClass::kPass;
  return {"fell at " + Seconds(fall_s) + (is_expected ? ", as expected" : ""), kFailRed, fall_s};
}

Outcome Recovered(const RunSummary& summary) {
  double slowest_s = 0.0;
  double done_s = 0.0;
  for (const PushSummary& push : summary.pushes) {
    slowest_s = std::max(slowest_s, push.recovery_time_s);
    done_s = std::max(done_s, push.start_s + push.duration_s + push.recovery_time_s);
  }
  std::string text = "recovered at once";  // it never left its path
  if (slowest_s >= kTold_s) {
    text = summary.pushes.size() == 1 ? "recovered " + Seconds(slowest_s) + " after the push"
                                      : "recovered within " + Seconds(slowest_s) + " of each push";
  }
  return {text, kPassGreen, done_s};
}

Outcome Judged(const RunSummary& summary, double last_s) {
  std::string text(EnumName(summary.verdict));
  if (summary.verdict == VerdictClass::kPass) return {text + ": no fall", kPassGreen, last_s};
  for (const ReasonSummary& reason : summary.reasons) {
    if (text.find(reason.kind) == std::string::npos) text += " " + reason.kind;
  }
  return {text, summary.verdict == VerdictClass::kFail ? kFailRed : kInvalidGrey, last_s};
}

}  // namespace

bool HasFallen(const RunSummary& summary) {
  const auto found = summary.metrics.find("fall");
  const bool* fell = found == summary.metrics.end() ? nullptr : std::get_if<bool>(&found->second);
  return fell != nullptr && *fell;
}

Outcome OutcomeOf(const RunSummary& summary) {
  const bool is_timed = std::isfinite(summary.simulated_s);
  const double last_s = is_timed ? std::max(0.0, summary.simulated_s - kVerdictShown_s) : 0.0;
  if (summary.verdict == VerdictClass::kInvalid) return Judged(summary, last_s);
  if (HasFallen(summary)) return Fallen(summary, last_s);
  const bool is_pass = summary.verdict == VerdictClass::kPass;
  const bool is_recovered =
      !summary.pushes.empty() &&
      std::all_of(summary.pushes.begin(), summary.pushes.end(), [](const PushSummary& push) {
        return push.recovered && std::isfinite(push.recovery_time_s);
      });
  return is_pass && is_recovered ? Recovered(summary) : Judged(summary, last_s);
}

}  // namespace sidestep::render
