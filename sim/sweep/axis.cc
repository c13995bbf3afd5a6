// SPDX-License-Identifier: BSD-3-Clause
#include "sim/sweep/axis.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <numbers>
#include <numeric>
#include <random>

#include "models/support/config_error.h"
#include "models/support/config_node.h"
#include "models/support/parse_number.h"
#include "sim/scenario/key_table.h"
#include "sim/scenario/yaml_writer.h"

namespace sidestep {
namespace {

constexpr double kRounding = 1e-9;      // of a range: what decimal steps may be off by
constexpr int kMostValues = 1'000'000;  // of one axis; catches a slip of the pen
constexpr std::uint64_t kLatinStream = 0x9E3779B97F4A7C15U;  // apart from the random axes

std::optional<double> PlainNumber(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  const std::optional<double> value = ParseAs<double>(text);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

std::vector<std::string> SplitAtColons(const std::string& text) {
  std::vector<std::string> parts(1);
  for (const char letter : text) {
    if (letter == ':') {
      parts.emplace_back();
    } else if (letter != ' ') {
      parts.back() += letter;
    }
  }
  return parts;
}

[[noreturn]] void Fail(const std::string& key, const ConfigPlace& place, const std::string& what) {
  FailAt(place, key + " " + what);
}

int Count(const Axis& axis, const std::string& text, int least, const ConfigPlace& place) {
  const std::optional<int> count = ParseAs<int>(text);
  if (!count) {
    Fail(axis.key, place,
         "= " + axis.text + ": '" + text + "' must be a count, a whole number; " +
             "for steps write a:b:step=s");
  }
  if (*count < least || *count > kMostValues) {
    Fail(axis.key, place,
         "= " + axis.text + ": a count must be from " + std::to_string(least) + " to " +
             std::to_string(kMostValues));
  }
  return *count;
}

// The shortest decimal that differs from `value` by no more than sums of decimals round: 0.6, not
// 0.6000000000000001.
std::string GridText(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.12g", value);
  const double rounded = *PlainNumber(text);
  constexpr double kRoundingOfSums = 1e-15;
  return NumberText(std::abs(rounded - value) <= kRoundingOfSums * std::abs(value) ? rounded
                                                                                   : value);
}

// Both ends, but of a whole turn of an angle.
void FillByCount(int count, Axis* axis) {
  const double range = axis->max - axis->min;
  const bool is_turn =
      axis->key.ends_with("_rad") && std::abs(range - 2.0 * std::numbers::pi) < kRounding;
  const int parts = is_turn ? count : count - 1;
  for (int i = 0; i < count; ++i) {
    const bool is_last = i == parts;  // without rounding
    axis->values.push_back(
        GridText(is_last ? axis->max : axis->min + range * i / static_cast<double>(parts)));
  }
}

void FillByStep(const std::string& text, const ConfigPlace& place, Axis* axis) {
  const std::optional<double> step = ParseNumber(text);
  if (!step || *step <= 0.0) {
    Fail(axis->key, place, "= " + axis->text + ": a step must be a number above 0");
  }
  const double steps = std::floor((axis->max - axis->min) / *step + kRounding);
  if (steps >= kMostValues) Fail(axis->key, place, "= " + axis->text + " has too many values");
  for (int i = 0; i <= static_cast<int>(steps); ++i) {
    axis->values.push_back(GridText(axis->min + i * *step));
  }
}

void ReadRange(const std::vector<std::string>& parts, const ConfigPlace& place, Axis* axis) {
  const std::optional<double> min = ParseNumber(parts[0]);
  const std::optional<double> max = ParseNumber(parts[1]);
  if (!min || !max) {
    Fail(axis->key, place,
         "= " + axis->text + ": '" + (min ? parts[1] : parts[0]) + "' is not a number");
  }
  axis->min = *min;
  axis->max = *max;
  if (axis->min >= axis->max) {
    Fail(axis->key, place, "= " + axis->text + " is an empty range: it must go upwards");
  }
  const std::string& how = parts[2];
  const std::size_t equals = how.find('=');
  const std::string word = equals == std::string::npos ? "" : how.substr(0, equals);
  const std::string amount = equals == std::string::npos ? how : how.substr(equals + 1);
  if (word.empty()) {
    FillByCount(Count(*axis, amount, 2, place), axis);
  } else if (word == "step") {
    FillByStep(amount, place, axis);
  } else if (word == "random" || word == "latin") {
    axis->kind = word == "random" ? AxisKind::kRandom : AxisKind::kLatin;
    axis->count = Count(*axis, amount, 1, place);
  } else {
    Fail(axis->key, place,
         "= " + axis->text + ": '" + word +
             "' is not known; a range ends in n, step=s, random=n or latin=n");
  }
}

// A number of a list may be a multiple of pi; all else stays as it is.
std::string ListedValue(const ConfigTree& value) {
  if (value.kind != ConfigKind::kScalar || value.is_quoted) return FlowText(value);
  const std::optional<double> number = ParseNumber(value.scalar);
  const bool has_pi = value.scalar.find("pi") != std::string::npos;
  return number && has_pi ? NumberText(*number) : FlowText(value);
}

}  // namespace

std::optional<double> ParseNumber(const std::string& text) {
  const std::size_t pi = text.find("pi");
  if (pi == std::string::npos) return PlainNumber(text);
  std::string factor = text.substr(0, pi);
  const std::string rest = text.substr(pi + 2);
  if (factor.empty() || factor == "-" || factor == "+") factor += "1";
  if (factor.ends_with('*')) factor.pop_back();
  if (!rest.empty() && rest.front() != '/') return std::nullopt;
  const std::optional<double> numerator = PlainNumber(factor);
  const std::optional<double> denominator = rest.empty() ? 1.0 : PlainNumber(rest.substr(1));
  if (!numerator || !denominator || *denominator == 0.0) return std::nullopt;
  return *numerator * std::numbers::pi / *denominator;
}

std::string FlowText(const ConfigTree& value) {
  std::string text;
  switch (value.kind) {
    case ConfigKind::kNull:
      return "null";
    case ConfigKind::kScalar:
      if (!value.is_quoted && value.scalar.find_first_of(",[]{}#:\"'") == std::string::npos) {
        return value.scalar;
      }
      return YamlScalar(value.scalar);
    case ConfigKind::kList:
      for (const ConfigTree& child : value.children) {
        text += (text.empty() ? "" : ", ") + FlowText(child);
      }
      return "[" + text + "]";
    case ConfigKind::kMap:
      for (std::size_t i = 0; i < value.keys.size(); ++i) {
        text += (text.empty() ? "" : ", ") + YamlScalar(value.keys[i].text) + ": " +
                FlowText(value.children[i]);
      }
      return "{" + text + "}";
  }
  return text;
}

void CheckKey(const std::string& key, const ConfigPlace& place) {
  const KeyInfo root = ScenarioKeys();
  const std::size_t dot = key.rfind('.');
  const bool has_entry = dot != std::string::npos && dot + 2 == key.size() && key[dot + 1] >= '0' &&
                         key[dot + 1] < '3';
  try {
    // An entry of a vector is no key of its own.
    const bool is_entry = has_entry && FindKey(root, key.substr(0, dot)).kind == KeyKind::kVector;
    const KeyInfo& info = FindKey(root, is_entry ? key.substr(0, dot) : key);
    if (&info == &root) FailAt(place, "a key is missing");
  } catch (const ConfigError& error) {
    std::string what = error.what();
    if (what.starts_with("error: ")) what.erase(0, 7);
    FailAt(place, what);
  }
}

Axis ReadAxis(const std::string& key, const ConfigTree& value) {
  CheckKey(key, value.place);
  Axis axis;
  axis.key = key;
  axis.text = value.kind == ConfigKind::kScalar ? value.scalar : FlowText(value);
  if (value.kind == ConfigKind::kList) {
    for (const ConfigTree& child : value.children) axis.values.push_back(ListedValue(child));
    if (axis.values.empty()) Fail(key, value.place, "= [] is empty: it has no values");
    return axis;
  }
  const std::vector<std::string> parts = SplitAtColons(axis.text);
  if (value.kind != ConfigKind::kScalar || parts.size() != 3) {
    Fail(key, value.place,
         "must be a:b:n, a:b:step=s, a:b:random=n, a:b:latin=n or a list; " +
             std::string("one value goes under set"));
  }
  ReadRange(parts, value.place, &axis);
  return axis;
}

Axis ParseAxis(const std::string& option, const std::string& assignment) {
  const ConfigSource source{option + " " + assignment, false};
  const ConfigPlace place{std::make_shared<const ConfigSource>(source), 1, 1};
  const std::size_t equals = assignment.find('=');
  if (equals == std::string::npos) FailAt(place, "must read key=values");
  return ReadAxis(assignment.substr(0, equals), ParseConfig(assignment.substr(equals + 1), source));
}

std::vector<std::vector<double>> DrawAxes(const std::vector<Axis>& axes, AxisKind kind,
                                          std::uint64_t seed) {
  std::mt19937_64 random(kind == AxisKind::kLatin ? seed ^ kLatinStream : seed);
  // The standard leaves its distributions to the library; this is the same everywhere.
  const auto uniform = [&random] { return static_cast<double>(random() >> 11U) * 0x1.0p-53; };
  std::vector<std::vector<double>> rows;
  for (const Axis& axis : axes) {
    if (axis.kind != kind) continue;
    const std::size_t count = axis.size();
    rows.resize(count);
    std::vector<std::size_t> cell(count);
    std::iota(cell.begin(), cell.end(), std::size_t{0});
    for (std::size_t i = count; kind == AxisKind::kLatin && i > 1; --i) {
      std::swap(cell[i - 1], cell[random() % i]);
    }
    for (std::size_t i = 0; i < count; ++i) {
      const double parts = kind == AxisKind::kLatin ? static_cast<double>(count) : 1.0;
      const double offset = kind == AxisKind::kLatin ? static_cast<double>(cell[i]) : 0.0;
      rows[i].push_back(axis.min + (axis.max - axis.min) * (offset + uniform()) / parts);
    }
  }
  return rows;
}

}  // namespace sidestep
