// SPDX-License-Identifier: BSD-3-Clause
#include "sim/record/column_digits.h"

#include <array>
#include <charconv>
#include <cmath>
#include <utility>

#include "models/support/require.h"
#include "sim/record/output_file.h"

namespace sidestep {
namespace {

constexpr int kPlainDecimals = 7;  // quaternions; statuses and flags are whole anyway
constexpr int kMostDecimals = 9;
constexpr double kTooLargeForFixed = 1e15;  // has no decimal places left in a double

constexpr std::array<std::pair<std::string_view, int>, 9> kDecimalsOfUnit{{{"kgm2ps", 6},
                                                                           {"radps", 5},
                                                                           {"mps", 6},
                                                                           {"rad", 7},
                                                                           {"Nm", 4},
                                                                           {"ms", 3},
                                                                           {"m", 7},
                                                                           {"N", 3},
                                                                           {"s", 6}}};

}  // namespace

std::string_view ColumnUnit(std::string_view column) {
  const std::size_t underscore = column.rfind('_');
  if (underscore == std::string_view::npos) return {};
  const std::string_view end = column.substr(underscore + 1);
  for (const auto& [unit, decimals] : kDecimalsOfUnit) {
    if (end == unit) return unit;
  }
  return {};
}

int DecimalsOf(std::string_view column) {
  const std::string_view end = ColumnUnit(column);
  for (const auto& [unit, decimals] : kDecimalsOfUnit) {
    if (end == unit) return decimals;
  }
  return kPlainDecimals;
}

void AppendRounded(std::string& text, double value, int decimals) {
  SIDESTEP_REQUIRE(decimals >= 0 && decimals <= kMostDecimals, decimals);
  if (!(std::abs(value) < kTooLargeForFixed)) return AppendNumber(text, value);
  std::array<char, 32> digits;  // 15 before the point, 9 after it, and a sign
  const auto result = std::to_chars(digits.data(), digits.data() + digits.size(), value,
                                    std::chars_format::fixed, decimals);
  std::string_view shown(digits.data(), static_cast<std::size_t>(result.ptr - digits.data()));
  if (decimals > 0) {
    shown = shown.substr(0, shown.find_last_not_of('0') + 1);
    if (shown.ends_with('.')) shown.remove_suffix(1);
  }
  text.append(shown == "-0" ? "0" : shown);
}

}  // namespace sidestep
