// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// parse_number: a number that is the whole of a text, whatever the locale.

#include <charconv>
#include <optional>
#include <string_view>
#include <system_error>

namespace sidestep {

/// `text` as a T (double, int, ...) if it is one and nothing else; infinities and NaN are doubles.
template <typename T>
std::optional<T> ParseAs(std::string_view text) {
  T value{};
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || stop != end) return std::nullopt;
  return value;
}

}  // namespace sidestep
