// SPDX-License-Identifier: BSD-3-Clause
#include "sim/render/scratch_dir.h"

#include <unistd.h>

#include <string>
#include <system_error>

#include "models/support/config_error.h"

namespace sidestep::render {

ScratchDir::ScratchDir(const std::filesystem::path& file)
    : path_(std::filesystem::absolute(file).parent_path() /
            (".render." + std::to_string(getpid()))) {
  std::error_code failure;
  std::filesystem::create_directories(path_, failure);
  if (failure) {
    throw ConfigError(path_.string() + ": error: can't be created: " + failure.message());
  }
}

ScratchDir::~ScratchDir() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

void ScratchDir::MoveOut(std::string_view name, const std::filesystem::path& target) const {
  std::error_code failure;
  std::filesystem::rename(path_ / name, target, failure);
  if (!failure) return;
  throw ConfigError(target.string() + ": error: can't be written: " + failure.message());
}

}  // namespace sidestep::render
