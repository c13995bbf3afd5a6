// SPDX-License-Identifier: BSD-3-Clause
#include "sim/record/output_file.h"

#include <array>
#include <charconv>
#include <system_error>

#include "models/support/config_error.h"

namespace sidestep {
namespace {

constexpr std::size_t kBufferBytes = std::size_t{1} << 16;

[[noreturn]] void Fail(const std::filesystem::path& file) {
  throw ConfigError(file.string() + ": error: can't be written");
}

}  // namespace

void AppendNumber(std::string& text, double value) {
  std::array<char, 32> digits;  // the longest shortest double has 24 characters
  const auto result = std::to_chars(digits.data(), digits.data() + digits.size(), value);
  text.append(digits.data(), result.ptr);
}

OutputFile::OutputFile(const std::filesystem::path& file)
    : file_(file), out_(file, std::ios::binary | std::ios::trunc) {
  if (!out_) Fail(file_);
}

OutputFile::~OutputFile() {
  // Nobody is left to tell about a full disk here; Close() tells.
  out_.write(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
}

void OutputFile::Append(std::string_view row) {
  buffer_.append(row);
  if (buffer_.size() >= kBufferBytes) Flush();
}

void OutputFile::Flush() {
  out_.write(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
  buffer_.clear();
  out_.flush();
  if (!out_) Fail(file_);
}

void OutputFile::Close() {
  Flush();
  out_.close();
  if (!out_) Fail(file_);
}

void WriteWholeFile(const std::filesystem::path& file, std::string_view text) {
  std::filesystem::path part = file;
  part += ".part";
  OutputFile out(part);
  out.Append(text);
  out.Close();
  std::error_code error;
  std::filesystem::rename(part, file, error);
  if (error) Fail(file);
}

}  // namespace sidestep
