// SPDX-License-Identifier: BSD-3-Clause
#include "sim/render/scratch_dir.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <string>
#include <system_error>
#include <vector>

#include "models/support/config_error.h"

namespace sidestep::render {

namespace {

constexpr std::string_view kPrefix = ".render.";
constexpr int kMostAttempts = 5;

// A descriptor that holds the folder's lock, or -1 if another holds it or the folder is not there.
int Lock(const std::filesystem::path& folder) {
  const int descriptor = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
  if (descriptor < 0 || flock(descriptor, LOCK_EX | LOCK_NB) == 0) return descriptor;
  close(descriptor);
  return -1;
}

// What processes that were killed have left: nobody holds its lock.
void RemoveAbandoned(const std::filesystem::path& folder) {
  std::error_code ignored;
  std::vector<std::filesystem::path> abandoned;
  for (const auto& entry : std::filesystem::directory_iterator(folder, ignored)) {
    if (entry.path().filename().string().rfind(kPrefix, 0) == 0) abandoned.push_back(entry.path());
  }
  for (const std::filesystem::path& scratch : abandoned) {
    const int descriptor = Lock(scratch);
    if (descriptor < 0) continue;
    std::filesystem::remove_all(scratch, ignored);
    close(descriptor);
  }
}

}  // namespace

ScratchDir::ScratchDir(const std::filesystem::path& file)
    : path_(std::filesystem::absolute(file).parent_path() /
            (std::string(kPrefix) + std::to_string(getpid()))) {
  RemoveAbandoned(path_.parent_path());
  // Another process may take the folder for abandoned before it is locked: then once more. Where
  // nothing can be locked, it stays unlocked.
  bool is_there = false;
  for (int attempt = 0; attempt < kMostAttempts && !is_there; ++attempt) {
    std::error_code failure;
    std::filesystem::create_directories(path_, failure);
    if (failure) {
      throw ConfigError(path_.string() + ": error: can't be created: " + failure.message());
    }
    if (lock_ >= 0) close(lock_);
    lock_ = Lock(path_);
    is_there = std::filesystem::exists(path_, failure);
  }
}

ScratchDir::~ScratchDir() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
  if (lock_ >= 0) close(lock_);
}

void ScratchDir::MoveOut(std::string_view name, const std::filesystem::path& target) const {
  std::error_code failure;
  std::filesystem::rename(path_ / name, target, failure);
  if (!failure) return;
  throw ConfigError(target.string() + ": error: can't be written: " + failure.message());
}

}  // namespace sidestep::render
