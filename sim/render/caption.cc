// SPDX-License-Identifier: BSD-3-Clause
#include "sim/render/caption.h"

#include <algorithm>
#include <cstdio>

#include "sim/render/caption_colors.h"
#include "sim/render/decoration.h"
#include "sim/render/outcome.h"

namespace sidestep::render {
namespace {

constexpr double kFinal_s = 1.0;
constexpr std::size_t kMaxText = 80;  // characters; the layout cuts what does not fit
constexpr std::size_t kMaxReasons = 3;

std::string Format(const char* format, double a, double b = 0.0) {
  char text[64];
  std::snprintf(text, sizeof text, format, a, b);
  return text;
}

// Where the pushes act that the summary lists at this time: "r_hand", "torso + r_hand".
std::string PushedBodies(const RunSummary& summary, double time_s) {
  std::string bodies;
  for (const PushSummary& push : summary.pushes) {
    if (time_s < push.start_s || time_s > push.start_s + push.duration_s) continue;
    bodies += (bodies.empty() ? "" : " + ") + push.body;
  }
  return bodies;
}

std::string PushText(const StateRow& row, const RunSummary& summary) {
  const double force_N = row.push_force_W.norm();
  if (!(force_N > 0.0)) return "no push";
  const std::string bodies = PushedBodies(summary, row.time_s);
  return Format(force_N < 9.95 ? "PUSH %.1f N" : "PUSH %.0f N", force_N) +
         (bodies.empty() ? "" : " on " + bodies);
}

Eigen::Vector3f VerdictColor(VerdictClass verdict) {
  if (verdict == VerdictClass::kPass) return kPassGreen;
  return verdict == VerdictClass::kFail ? kFailRed : kInvalidGrey;
}

std::string ReasonText(const ReasonSummary& reason) {
  std::string text = reason.kind;
  if (!reason.text.empty()) text += ": " + reason.text;
  if (reason.time_s) text += Format(" at %.2f s", *reason.time_s);
  return text;
}

void AddVerdict(const RunSummary& summary, bool is_final, std::vector<Caption>* captions) {
  const std::string verdict(EnumName(summary.verdict));
  const Eigen::Vector3f color = VerdictColor(summary.verdict);
  if (!is_final) {
    std::string kinds;
    for (const ReasonSummary& reason : summary.reasons) {
      if (kinds.find(reason.kind) == std::string::npos) kinds += " " + reason.kind;
    }
    captions->push_back({CaptionPlace::kTopRight, Printable(verdict + kinds, kMaxText), color});
    return;
  }
  if (summary.verdict == VerdictClass::kPass && HasFallen(summary)) {
    captions->push_back({CaptionPlace::kBottom, "FELL", kFailRed, true});
    captions->push_back({CaptionPlace::kBottom, "as expected: " + verdict, color});
    return;
  }
  captions->push_back({CaptionPlace::kBottom, Printable(verdict, kMaxText), color, true});
  for (std::size_t i = 0; i < std::min(kMaxReasons, summary.reasons.size()); ++i) {
    captions->push_back(
        {CaptionPlace::kBottom, Printable(ReasonText(summary.reasons[i]), kMaxText), color});
  }
}

}  // namespace

std::vector<Caption> CaptionsAt(const StateRow& row, double end_s, const RunSummary& summary,
                                double speed) {
  std::vector<Caption> captions;
  const auto add_left = [&](const std::string& text, const Eigen::Vector3f& color) {
    captions.push_back({CaptionPlace::kTopLeft, Printable(text, kMaxText), color});
  };
  if (!summary.name.empty()) add_left(summary.name, kInk);
  const std::string slow = speed == 1.0 ? "" : Format(", %.3gx", speed);
  add_left(Format("%.2f s / %.2f s", row.time_s, end_s) + slow, kInk);
  const bool is_pushed = row.push_force_W.norm() > 0.0;
  add_left(PushText(row, summary), is_pushed ? kPushMagenta : kInk);
  AddVerdict(summary, row.time_s > end_s - kFinal_s, &captions);
  return captions;
}

std::vector<Caption> LegendAt(const StateRow& row, double end_s, const RunSummary& summary,
                              const std::vector<std::string>& feet) {
  if (row.time_s > end_s - kFinal_s) return {};
  std::vector<Caption> legend;
  const auto add = [&](const std::string& text, const Color& color) {
    legend.push_back({CaptionPlace::kBottomLeft, Printable(text, kMaxText), kInk, false,
                      Eigen::Vector3f(color.head<3>())});
  };
  if (!summary.pushes.empty()) add("push", kPushColor);
  for (std::size_t i = 0; i < feet.size(); ++i) {
    add(feet[i] + ": foothold, force", FootColor(i));
  }
  add("foothold of the gait", kNominalColor);
  add("path of the CoM", kComTraceColor);
  return legend;
}

std::string Printable(const std::string& text, std::size_t max_length) {
  std::string printable = text;
  for (char& c : printable) {
    if (c < ' ' || c > '~') c = '?';
  }
  if (printable.size() > max_length) printable.replace(max_length - 2, std::string::npos, "..");
  return printable;
}

}  // namespace sidestep::render
