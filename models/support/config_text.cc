// SPDX-License-Identifier: BSD-3-Clause
#include "models/support/config_text.h"

#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <fstream>
#include <system_error>

#include "models/support/config_error.h"
#include "models/support/utf8.h"

namespace sidestep {
namespace {

constexpr std::size_t kMaxBytes = 1 << 20;  // The longest shipped file has a few hundred lines.

[[noreturn]] void FailToRead(const std::filesystem::path& file, const std::string& why) {
  throw ConfigError(file.string() + ": error: can't be read: " + why);
}

std::string HexByte(char value) {
  char text[8];
  std::snprintf(text, sizeof(text), "0x%02X",
                static_cast<unsigned>(static_cast<unsigned char>(value)));
  return text;
}

}  // namespace

std::string ReadConfigText(const std::filesystem::path& file) {
  std::error_code ignored;
  if (std::filesystem::is_directory(file, ignored)) FailToRead(file, "is a folder");
  std::ifstream stream(file, std::ios::binary);
  if (!stream) FailToRead(file, std::generic_category().message(errno));
  std::string text(kMaxBytes + 1, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (stream.bad()) FailToRead(file, "reading failed");
  text.resize(static_cast<std::size_t>(stream.gcount()));
  if (text.size() > kMaxBytes) FailToRead(file, "is longer than 1 MiB");
  return text;
}

std::optional<TextFault> FindTextFault(const std::string& text) {
  int line = 1;
  std::size_t line_start = 0;
  for (std::size_t i = 0; i < text.size();) {
    const auto code = static_cast<unsigned char>(text[i]);
    const std::size_t length = Utf8Length(text, i);
    const bool is_blank = code == '\t' || code == '\n' || code == '\r';
    const int column = static_cast<int>(i - line_start) + 1;
    if (length == 0) return TextFault{line, column, "byte " + HexByte(text[i]) + " is no UTF-8"};
    if ((code < 0x20U && !is_blank) || code == 0x7FU) {
      return TextFault{line, column, "control character " + HexByte(text[i])};
    }
    i += length;
    if (code == '\n') {
      ++line;
      line_start = i;
    }
  }
  return std::nullopt;
}

}  // namespace sidestep
