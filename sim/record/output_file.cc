// SPDX-License-Identifier: BSD-3-Clause
#include "sim/record/output_file.h"

#include <array>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <system_error>

#include "models/support/config_error.h"
#include "models/support/require.h"

namespace sidestep {
namespace {

constexpr std::size_t kBufferBytes = std::size_t{1} << 16;

}  // namespace

void FailToWrite(const std::filesystem::path& file) {
  const std::string why = errno == 0 ? "" : std::string(": ") + std::strerror(errno);
  throw ConfigError(file.string() + ": error: can't be written" + why);
}

void AppendNumber(std::string& text, double value) {
  std::array<char, 32> digits;  // the longest shortest double has 24 characters
  const auto result = std::to_chars(digits.data(), digits.data() + digits.size(), value);
  text.append(digits.data(), result.ptr);
}

OutputFile::OutputFile(const std::filesystem::path& file) : file_(file) {
  errno = 0;
  out_.open(file_, std::ios::binary | std::ios::trunc);
  if (!out_) FailToWrite(file_);
}

OutputFile::OutputFile(const std::filesystem::path& file, const OutputFile& start)
    : file_(file), buffer_(start.buffer_), bytes_on_disk_(start.bytes_on_disk_) {
  SIDESTEP_REQUIRE(start.out_.is_open(), start.file_);
  CopyWholeFile(start.file_, file_);  // between two flushes the stream itself holds nothing back
  std::error_code error;
  if (std::filesystem::file_size(file_, error) != bytes_on_disk_) {
    throw ConfigError(start.file_.string() + ": error: was changed while the run wrote it");
  }
  out_.open(file_, std::ios::binary | std::ios::app);
  if (!out_) FailToWrite(file_);
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
  errno = 0;
  out_.write(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
  out_.flush();
  if (!out_) FailToWrite(file_);
  bytes_on_disk_ += buffer_.size();
  buffer_.clear();
}

void OutputFile::Close() {
  Flush();
  out_.close();
  if (!out_) FailToWrite(file_);
}

void WriteWholeFile(const std::filesystem::path& file, std::string_view text) {
  std::filesystem::path part = file;
  part += ".part";
  errno = 0;
  std::ofstream out(part, std::ios::binary | std::ios::trunc);
  out.write(text.data(), static_cast<std::streamsize>(text.size()));
  out.close();
  std::error_code error;
  if (!out) {
    const int reason = errno;
    std::filesystem::remove(part, error);  // it would keep a full disk full
    errno = reason;
    FailToWrite(file);
  }
  std::filesystem::rename(part, file, error);
  if (!error) return;
  std::error_code ignored;
  std::filesystem::remove(part, ignored);
  throw ConfigError(file.string() + ": error: can't be written: " + error.message());
}

void CopyWholeFile(const std::filesystem::path& from, const std::filesystem::path& to) {
  std::error_code error;
  std::filesystem::copy_file(from, to, std::filesystem::copy_options::overwrite_existing, error);
  if (error) {
    throw ConfigError(to.string() + ": error: can't be copied from " + from.string() + ": " +
                      error.message());
  }
}

void RequireOtherFolder(const std::filesystem::path& run_dir,
                        const std::filesystem::path& fork_dir) {
  std::error_code ignored;  // a folder that is not there yet
  const auto plain = [&](const std::filesystem::path& folder) {
    return std::filesystem::weakly_canonical(folder / ".", ignored);
  };
  const bool is_same =
      std::filesystem::equivalent(run_dir, fork_dir, ignored) || plain(run_dir) == plain(fork_dir);
  if (!is_same) return;
  throw ConfigError(fork_dir.string() + ": error: a fork can't go into the folder of its own run");
}

}  // namespace sidestep
