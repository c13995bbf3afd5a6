// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// text_place: where in a file something stands, as messages tell it.

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace sidestep {

/// Line and column of a text, from 1; 0 is unknown. Columns count bytes.
struct TextPlace {
  int line{0};
  int column{0};
};

/// The place of the byte `at` of `text`.
inline TextPlace PlaceIn(std::string_view text, std::size_t at) {
  const std::string_view before = text.substr(0, at);
  const auto line = std::count(before.begin(), before.end(), '\n') + 1;
  const std::size_t line_start = before.rfind('\n') + 1;  // npos + 1 is 0
  return {static_cast<int>(line), static_cast<int>(before.size() - line_start) + 1};
}

}  // namespace sidestep
