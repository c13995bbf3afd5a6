// SPDX-License-Identifier: BSD-3-Clause
#include "sim/render/caption.h"

#include <algorithm>
#include <cstdio>

namespace sidestep::render {
namespace {

const Eigen::Vector3f kInk{0.10F, 0.11F, 0.13F};
const Eigen::Vector3f kPassGreen{0.05F, 0.45F, 0.30F};
const Eigen::Vector3f kFailRed{0.72F, 0.12F, 0.10F};
const Eigen::Vector3f kInvalidGrey{0.40F, 0.40F, 0.42F};
const Eigen::Vector3f kPushMagenta{0.78F, 0.00F, 0.40F};

constexpr double kFinal_s = 1.0;
constexpr std::size_t kMaxText = 80;  // characters; the layout cuts what does not fit
constexpr std::size_t kMaxReasons = 3;

std::string Format(const char* format, double a, double b = 0.0) {
  char text[64];
  std::snprintf(text, sizeof text, format, a, b);
  return text;
}

// A string field that may be missing or of another type.
std::string TextOf(const nlohmann::json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

double NumberOf(const nlohmann::json& object, const char* key, double otherwise) {
  const auto found = object.find(key);
  return found != object.end() && found->is_number() ? found->get<double>() : otherwise;
}

nlohmann::json ArrayOf(const nlohmann::json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_array() ? *found : nlohmann::json::array();
}

// Where the pushes act that the summary lists at this time: "r_hand", "torso + r_hand".
std::string PushedBodies(const nlohmann::json& summary, double time_s) {
  std::string bodies;
  for (const nlohmann::json& push : ArrayOf(summary, "pushes")) {
    const double start_s = NumberOf(push, "start_s", 0.0);
    const double end_s = start_s + NumberOf(push, "duration_s", 0.0);
    if (time_s < start_s || time_s > end_s) continue;
    bodies += (bodies.empty() ? "" : " + ") + TextOf(push, "body");
  }
  return bodies;
}

std::string PushText(const StateRow& row, const nlohmann::json& summary) {
  const double force_N = row.push_force_W.norm();
  if (!(force_N > 0.0)) return "no push";
  const std::string bodies = PushedBodies(summary, row.time_s);
  return Format(force_N < 9.95 ? "PUSH %.1f N" : "PUSH %.0f N", force_N) +
         (bodies.empty() ? "" : " on " + bodies);
}

Eigen::Vector3f VerdictColor(const std::string& verdict) {
  if (verdict == "PASS") return kPassGreen;
  return verdict == "FAIL" ? kFailRed : kInvalidGrey;
}

std::string ReasonText(const nlohmann::json& reason) {
  std::string text = TextOf(reason, "class");
  const std::string what = TextOf(reason, "text");
  if (!what.empty()) text += ": " + what;
  const double time_s = NumberOf(reason, "time_s", -1.0);
  if (time_s >= 0.0) text += Format(" at %.2f s", time_s);
  return text;
}

void AddVerdict(const nlohmann::json& summary, bool is_final, std::vector<Caption>* captions) {
  const std::string verdict = TextOf(summary, "verdict");
  if (verdict.empty()) return;
  const Eigen::Vector3f color = VerdictColor(verdict);
  const nlohmann::json reasons = ArrayOf(summary, "reasons");
  if (!is_final) {
    std::string classes;
    for (const nlohmann::json& reason : reasons) {
      const std::string name = TextOf(reason, "class");
      if (classes.find(name) == std::string::npos) classes += " " + name;
    }
    captions->push_back(
        {CaptionPlace::kTopRight, Printable(verdict + classes, kMaxText), color, false});
    return;
  }
  captions->push_back({CaptionPlace::kBottom, Printable(verdict, kMaxText), color, true});
  for (std::size_t i = 0; i < std::min(kMaxReasons, reasons.size()); ++i) {
    captions->push_back(
        {CaptionPlace::kBottom, Printable(ReasonText(reasons[i]), kMaxText), color, false});
  }
}

}  // namespace

std::vector<Caption> CaptionsAt(const StateRow& row, double end_s, const nlohmann::json& summary) {
  std::vector<Caption> captions;
  const auto add_left = [&](const std::string& text, const Eigen::Vector3f& color) {
    captions.push_back({CaptionPlace::kTopLeft, Printable(text, kMaxText), color, false});
  };
  const std::string name = TextOf(summary, "name");
  if (!name.empty()) add_left(name, kInk);
  add_left(Format("%.2f s / %.2f s", row.time_s, end_s), kInk);
  const bool is_pushed = row.push_force_W.norm() > 0.0;
  add_left(PushText(row, summary), is_pushed ? kPushMagenta : kInk);
  AddVerdict(summary, row.time_s > end_s - kFinal_s, &captions);
  return captions;
}

std::string Printable(const std::string& text, std::size_t max_length) {
  std::string printable = text;
  for (char& c : printable) {
    if (c < ' ' || c > '~') c = '?';
  }
  if (printable.size() > max_length) printable = printable.substr(0, max_length - 2) + "..";
  return printable;
}

}  // namespace sidestep::render
