// SPDX-License-Identifier: BSD-3-Clause
#include "sim/apps/commands/progress.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

namespace sidestep {
namespace {

using Clock = std::chrono::steady_clock;

constexpr auto kTerminalPeriod = std::chrono::milliseconds(100);
constexpr auto kPipePeriod = std::chrono::seconds(5);
constexpr std::size_t kBarWidth = 24;
constexpr double kShareForEstimate = 0.02;

}  // namespace

std::string ProgressText(const std::string& label, double share, const std::string& detail,
                         double elapsed_s, std::size_t bar_width) {
  share = std::clamp(share, 0.0, 1.0);
  std::string text = label;
  if (bar_width > 0) {
    const auto full = static_cast<std::size_t>(std::floor(share * static_cast<double>(bar_width)));
    text += " [" + std::string(full, '#') + std::string(bar_width - full, '-') + "]";
  }
  char percent[16];
  std::snprintf(percent, sizeof percent, " %3.0f %%", 100.0 * share);
  text += percent;
  if (!detail.empty()) text += ", " + detail;
  if (share >= kShareForEstimate && share < 1.0) {
    const double left_s = elapsed_s * (1.0 - share) / share;
    text += ", about " + std::to_string(std::lround(std::ceil(left_s))) + " s left";
  }
  return text;
}

Progress::Progress(std::string label, bool is_quiet)
    : label_(std::move(label)),
      is_quiet_(is_quiet),
      is_terminal_(isatty(STDERR_FILENO) == 1),
      start_(Clock::now()),
      last_(is_terminal_ ? Clock::time_point() : start_) {}

Progress::~Progress() { Clear(); }

void Progress::Update(double share, const std::string& detail) {
  if (is_quiet_) return;
  const auto now = Clock::now();
  const bool is_due = is_terminal_ ? now - last_ >= kTerminalPeriod : now - last_ >= kPipePeriod;
  if (!is_due) return;
  last_ = now;
  const double elapsed_s = std::chrono::duration<double>(now - start_).count();
  if (!is_terminal_) {
    std::fprintf(stderr, "%s\n", ProgressText(label_, share, detail, elapsed_s, 0).c_str());
    return;
  }
  const std::string text = ProgressText(label_, share, detail, elapsed_s, kBarWidth);
  const std::string padding(drawn_ > text.size() ? drawn_ - text.size() : 0, ' ');
  std::fprintf(stderr, "\r%s%s", text.c_str(), padding.c_str());
  drawn_ = text.size();
}

void Progress::Say(const std::string& line) {
  if (is_quiet_) return;
  Clear();
  std::fprintf(stderr, "%s\n", line.c_str());
}

void Progress::Clear() {
  if (drawn_ == 0) return;
  std::fprintf(stderr, "\r%s\r", std::string(drawn_, ' ').c_str());
  drawn_ = 0;
}

}  // namespace sidestep
