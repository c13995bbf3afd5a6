// SPDX-License-Identifier: BSD-3-Clause
#include "sim/sweep/row_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>

#include "models/support/config_error.h"

namespace sidestep {
namespace {

[[noreturn]] void FailAtRows(const std::filesystem::path& file, const std::string& what) {
  throw ConfigError(file.string() + ": error: " + what);
}

}  // namespace

RowsOnDisk ReadRows(const SweepSpec& spec, const std::filesystem::path& file) {
  std::error_code ignored;  // of one that is not there, which has no rows
  const std::filesystem::file_status status = std::filesystem::status(file, ignored);
  if (exists(status) && !is_regular_file(status)) FailAtRows(file, "is no file of rows");
  std::ifstream in(file, std::ios::binary);
  std::ostringstream all;
  if (in) all << in.rdbuf();
  const std::string text = all.str();
  RowsOnDisk found;
  int number = 0;
  std::size_t end = 0;
  for (std::size_t at = 0; (end = text.find('\n', at)) != std::string::npos; at = end + 1) {
    const std::string line = text.substr(at, end - at);
    ++number;
    if (number > 1) {
      found.rows.push_back(ReadRow(spec, line, file.string() + ":" + std::to_string(number)));
    } else if (line != RowHeader(spec)) {
      throw ConfigError(file.string() + ":1: error: has the columns of another sweep or program");
    }
    found.whole_bytes = end + 1;
  }
  found.has_half_row = found.whole_bytes < text.size();
  return found;
}

RowFile::RowFile(const SweepSpec& spec, const std::filesystem::path& file,
                 const std::function<void(const std::string&)>& note)
    : file_(file),
      descriptor_(open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NONBLOCK, 0666)) {
  if (descriptor_ < 0) FailAtRows(file, std::string("can't be written: ") + std::strerror(errno));
  try {
    if (flock(descriptor_, LOCK_EX | LOCK_NB) != 0) {
      FailAtRows(file, "another sweep is writing here; wait for it or take another folder");
    }
    RowsOnDisk found = ReadRows(spec, file);
    rows_ = std::move(found.rows);
    if (found.has_half_row) {
      note(file.string() + ": note: dropped a half-written last row; its run is done again");
    }
    if (ftruncate(descriptor_, static_cast<off_t>(found.whole_bytes)) != 0 ||
        lseek(descriptor_, 0, SEEK_END) < 0) {
      FailAtRows(file, std::string("can't be written: ") + std::strerror(errno));
    }
    if (found.whole_bytes == 0) Append(RowHeader(spec));
  } catch (...) {
    close(descriptor_);
    throw;
  }
}

RowFile::~RowFile() { Forget(); }

void RowFile::Forget() {
  if (descriptor_ >= 0) close(descriptor_);
  descriptor_ = -1;
}

void RowFile::Append(const std::string& line) {
  const std::string text = line + "\n";
  std::size_t done = 0;
  while (done < text.size()) {
    const ssize_t wrote = write(descriptor_, text.data() + done, text.size() - done);
    if (wrote < 0 && errno == EINTR) continue;
    if (wrote <= 0) FailAtRows(file_, std::string("can't be written: ") + std::strerror(errno));
    done += static_cast<std::size_t>(wrote);
  }
  if (fsync(descriptor_) != 0)
    FailAtRows(file_, std::string("can't be saved: ") + std::strerror(errno));
}

}  // namespace sidestep
