// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// config_text: the bytes of a user's file, checked before a parser sees them.

#include <filesystem>
#include <optional>
#include <string>

namespace sidestep {

/// Contents of a file of at most 1 MiB. Throws ConfigError (`file: error: ...`) if it is longer,
/// a folder, missing or unreadable.
std::string ReadConfigText(const std::filesystem::path& file);

/// Why and where a text can't be one of ours. Line and column (in bytes) count from 1.
struct TextFault {
  int line;
  int column;
  std::string what;
};

/// The first control character (but tab, newline, carriage return) or byte that is no UTF-8.
/// yaml-cpp takes 0x04 for the end of the file and would read the rest as absent.
std::optional<TextFault> FindTextFault(const std::string& text);

}  // namespace sidestep
