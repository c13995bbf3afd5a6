// SPDX-License-Identifier: BSD-3-Clause
#include "sim/check/junit.h"

#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <filesystem>

namespace sidestep {
namespace {

// Length of the well-formed UTF-8 character of XML 1.0 that `text` starts with; 0 if there is none.
std::size_t CharacterLength(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(text[i]); };
  const std::uint8_t first = byte(0);
  if (first < 0x80) {
    return first >= 0x20 || first == '\t' || first == '\n' || first == '\r' ? 1 : 0;
  }
  const std::size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC2 || first > 0xF4 || text.size() < length) return 0;
  std::uint32_t code = first & (0xFFU >> (length + 1));
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0U) != 0x80U) return 0;
    code = (code << 6U) | (byte(i) & 0x3FU);
  }
  constexpr std::uint32_t kSmallest[] = {0, 0, 0x80, 0x800, 0x10000};
  const bool is_surrogate = code >= 0xD800 && code <= 0xDFFF;
  const bool is_forbidden = code == 0xFFFE || code == 0xFFFF || code > 0x10FFFF;
  return code < kSmallest[length] || is_surrogate || is_forbidden ? 0 : length;
}

std::string Seconds(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3f", value);
  return text;
}

std::string Attribute(const char* name, std::string_view value) {
  return std::string(" ") + name + "=\"" + XmlEscape(value) + "\"";
}

std::string Lines(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

// What a reader of the CI page needs: where it is, what was measured, last words.
std::string Details(const Outcome& outcome) {
  std::string text = "scenario: " + outcome.file.string() + "\nrun: " + outcome.run_dir.string() +
                     "\n" + Lines(outcome.reasons) + Lines(outcome.measured);
  if (!outcome.error_output.empty()) text += "stderr:\n" + outcome.error_output + "\n";
  return text;
}

// Jenkins and GitLab show files that are told like this.
std::string Attachments(const Outcome& outcome) {
  std::string text;
  for (const char* name : {"report.html", "video.mp4"}) {
    const std::filesystem::path file = std::filesystem::absolute(outcome.run_dir / name);
    if (std::filesystem::exists(file)) text += "[[ATTACHMENT|" + file.string() + "]]\n";
  }
  return text;
}

std::string TestCase(const Outcome& outcome) {
  std::string xml = "    <testcase" + Attribute("name", outcome.name) +
                    Attribute("classname", "sidestep." + outcome.robot) +
                    Attribute("time", Seconds(outcome.wall_s)) + ">\n";
  if (outcome.verdict != VerdictClass::kPass) {
    const char* element = outcome.verdict == VerdictClass::kFail ? "failure" : "error";
    const std::string message = outcome.reasons.empty() ? "no reason given" : outcome.reasons[0];
    const std::string type = message.substr(0, message.find_first_of(" :"));
    xml += std::string("      <") + element + Attribute("message", message) +
           Attribute("type", type) + ">" + XmlEscape(Lines(outcome.reasons)) + "</" + element +
           ">\n";
  }
  xml +=
      "      <system-out>" + XmlEscape(Details(outcome) + Attachments(outcome)) + "</system-out>\n";
  return xml + "    </testcase>\n";
}

}  // namespace

std::string XmlEscape(std::string_view text) {
  std::string escaped;
  while (!text.empty()) {
    const std::size_t length = CharacterLength(text);
    const char c = text[0];
    if (length == 1 && c == '&') {
      escaped += "&amp;";
    } else if (length == 1 && c == '<') {
      escaped += "&lt;";
    } else if (length == 1 && c == '>') {
      escaped += "&gt;";
    } else if (length == 1 && c == '"') {
      escaped += "&quot;";
    } else if (length == 1 && (c == '\n' || c == '\r' || c == '\t')) {
      escaped += "&#" + std::to_string(static_cast<int>(c)) + ";";
    } else {
      escaped += text.substr(0, length);
    }
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return escaped;
}

CheckPlace ThisPlace() {
  CheckPlace place;
  char text[256] = {};
  const std::time_t now = std::time(nullptr);
  std::tm utc{};
  gmtime_r(&now, &utc);
  if (std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%S", &utc) > 0) place.timestamp = text;
  if (gethostname(text, sizeof text - 1) == 0) place.hostname = text;
  return place;
}

std::string JunitXml(const std::vector<Outcome>& outcomes, double wall_s, const CheckPlace& place) {
  const auto count = [&](VerdictClass verdict) {
    return std::to_string(
        std::count_if(outcomes.begin(), outcomes.end(),
                      [&](const Outcome& outcome) { return outcome.verdict == verdict; }));
  };
  const std::string totals = Attribute("tests", std::to_string(outcomes.size())) +
                             Attribute("failures", count(VerdictClass::kFail)) +
                             Attribute("errors", count(VerdictClass::kInvalid)) +
                             Attribute("time", Seconds(wall_s));
  std::string xml = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites" + totals +
                    ">\n  <testsuite" + Attribute("name", "sidestep") + totals +
                    Attribute("timestamp", place.timestamp) +
                    Attribute("hostname", place.hostname) + ">\n";
  for (const Outcome& outcome : outcomes) xml += TestCase(outcome);
  return xml + "  </testsuite>\n</testsuites>\n";
}

}  // namespace sidestep
