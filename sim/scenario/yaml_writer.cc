// SPDX-License-Identifier: BSD-3-Clause
#include "sim/scenario/yaml_writer.h"

#include <algorithm>
#include <array>
#include <cstdio>

namespace sidestep {
namespace {

bool IsLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

/// Words that YAML may take for something else than text.
bool IsReserved(std::string_view text) {
  constexpr std::array<std::string_view, 9> kReserved{"null", "true", "false", "yes", "no",
                                                      "on",   "off",  "y",     "n"};
  std::string lower(text);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  return std::find(kReserved.begin(), kReserved.end(), lower) != kReserved.end();
}

bool IsPlain(std::string_view text) {
  const auto is_word = [](char c) {
    return IsLetter(c) || (c >= '0' && c <= '9') || c == '_' || c == '-' || c == '.' || c == '/';
  };
  return !text.empty() && (IsLetter(text[0]) || text[0] == '_' || text[0] == '/') &&
         std::all_of(text.begin(), text.end(), is_word) && !IsReserved(text);
}

}  // namespace

std::string YamlScalar(std::string_view text) {
  if (IsPlain(text)) return std::string(text);
  std::string quoted = "\"";
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      quoted += '\\';
      quoted += c;
    } else if (code < 0x20U || code == 0x7FU) {
      std::array<char, 8> escape{};
      std::snprintf(escape.data(), escape.size(), "\\x%02x", static_cast<unsigned>(code));
      quoted += escape.data();
    } else {
      quoted += c;
    }
  }
  return quoted + '"';
}

std::string YamlNumber(double value) {
  std::string text = NumberText(value);
  const std::size_t power = text.find('e');
  if (power != std::string::npos && text.find('.') == std::string::npos) text.insert(power, ".0");
  return text;
}

std::string YamlVector(const Eigen::Vector3d& value) {
  return "[" + YamlNumber(value.x()) + ", " + YamlNumber(value.y()) + ", " + YamlNumber(value.z()) +
         "]";
}

std::string YamlSize(const PixelSize& size) {
  return "[" + std::to_string(size.width_px) + ", " + std::to_string(size.height_px) + "]";
}

void YamlWriter::Line(std::string_view key, std::string_view value) {
  const int columns = 2 * depth_ - (has_dash_ ? 2 : 0);
  text_ += std::string(static_cast<std::size_t>(columns), ' ') + (has_dash_ ? "- " : "");
  text_ += std::string(key) + ":";
  if (!value.empty()) text_ += " " + std::string(value);
  text_ += "\n";
  has_dash_ = false;
}

void YamlWriter::Begin(std::string_view key) {
  Line(key, "");
  ++depth_;
}

void YamlWriter::BeginElement() {
  ++depth_;
  has_dash_ = true;
}

}  // namespace sidestep
