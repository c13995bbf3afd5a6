// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// plain_word: names that mean nothing to a shell, a plotter, a browser or a table.
//
// Names from files end up in folders, columns, scripts and pages. Each of these quotes what it is
// given; that names are plain is the second lock on the same door.

#include <algorithm>
#include <string>
#include <string_view>

namespace sidestep {

inline constexpr std::string_view kPlainCharacters =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-.";
inline constexpr std::size_t kMaxWordLength = 100;  ///< It may name a folder; those allow 255.

/// What IsPlainWord() asks for, to stand after "must be".
inline constexpr std::string_view kPlainWordRule =
    "1 to 100 letters, digits, '_', '-' or '.', and begin with neither '-' nor '.'";

/// True for a name of plain characters, neither empty nor too long, that no program takes for an
/// option or a hidden file.
constexpr bool IsPlainWord(std::string_view name) {
  return !name.empty() && name.size() <= kMaxWordLength && name[0] != '.' && name[0] != '-' &&
         name.find_first_not_of(kPlainCharacters) == std::string_view::npos;
}

/// `name` with a '_' for every other character: no plain word yet, as it may be empty, too long or
/// begin with a '-'.
inline std::string PlainCharactersOf(std::string_view name) {
  std::string plain(name);
  std::replace_if(
      plain.begin(), plain.end(),
      [](char c) { return kPlainCharacters.find(c) == std::string_view::npos; }, '_');
  return plain;
}

}  // namespace sidestep
