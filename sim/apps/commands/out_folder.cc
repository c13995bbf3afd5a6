// SPDX-License-Identifier: BSD-3-Clause
#include "sim/apps/commands/out_folder.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <fstream>
#include <set>
#include <system_error>
#include <utility>

#include "models/support/config_error.h"
#include "sim/record/output_file.h"
#include "sim/record/run_files.h"

namespace sidestep {
namespace {

namespace fs = std::filesystem;

constexpr const char* kRunMark = "scenario.yaml";
constexpr std::array<const char*, 10> kRunNames{
    "trajectory.csv", "footsteps.csv", "mpc.csv", "states.bin", "summary.json",
    "video.mp4",      "report.html",   "plots",   "problems",   kRunMark};

[[noreturn]] void Refuse(const fs::path& folder, const std::string& why) {
  throw ConfigError(folder.string() + ": error: " + why);
}

// A name that a run writes to, but that no run has listed: somebody else's.
void RequireNoForeignNames(const fs::path& folder) {
  std::set<std::string> own;
  for (const fs::path name : ListedRunFiles(folder)) own.insert(name.begin()->string());
  for (const char* name : kRunNames) {
    const bool is_foreign = own.count(name) == 0 || fs::is_symlink(folder / name);
    std::error_code ignored;
    if (!is_foreign || !fs::exists(fs::symlink_status(folder / name, ignored))) continue;
    Refuse(folder, std::string("holds ") + name + ", which is not on its list of a run's files (" +
                       kRunFilesName + "); --force replaces only those");
  }
}

}  // namespace

void CheckOutFolder(const fs::path& folder, bool may_replace) {
  if (!fs::exists(folder)) return;
  if (!fs::is_directory(folder)) Refuse(folder, "is not a folder");
  if (fs::is_empty(folder)) return;
  if (!may_replace) Refuse(folder, "the output folder is not empty; --force replaces a run in it");
  if (!fs::is_regular_file(fs::symlink_status(folder / kRunFilesName))) {
    Refuse(folder, std::string("holds other files but no run (no ") + kRunFilesName +
                       "); --force replaces only runs");
  }
  RequireNoForeignNames(folder);
}

OutFolderLock::OutFolderLock(const fs::path& folder)
    : descriptor_(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
  if (descriptor_ >= 0 && flock(descriptor_, LOCK_EX | LOCK_NB) == 0) return;
  const bool is_held = errno == EWOULDBLOCK;
  if (descriptor_ >= 0) close(descriptor_);
  Refuse(folder, is_held ? "another run is writing to it" : "can't be locked");
}

OutFolderLock::OutFolderLock(OutFolderLock&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)) {}

OutFolderLock::~OutFolderLock() {
  if (descriptor_ >= 0) close(descriptor_);
}

OutFolderLock PrepareOutFolder(const fs::path& folder, bool may_replace) {
  try {
    CheckOutFolder(folder, may_replace);
    fs::create_directories(folder);
    OutFolderLock lock(folder);
    CheckOutFolder(folder, may_replace);  // what another run may have begun meanwhile
    RemoveListedRunFiles(folder);
    return lock;
  } catch (const fs::filesystem_error& error) {
    Refuse(folder, "can't be used as the output folder: " + error.code().message());
  }
}

void RequireRunFolder(const fs::path& folder) {
  if (!fs::is_directory(folder)) Refuse(folder, "is not a folder");
  if (!fs::exists(folder / kRunMark)) Refuse(folder, "is not a run's folder (no scenario.yaml)");
}

void CheckOutFile(const fs::path& file, bool may_replace) {
  if (fs::is_directory(file)) Refuse(file, "is a folder");
  if (!fs::is_directory(fs::absolute(file).parent_path())) Refuse(file, "its folder is not there");
  if (fs::exists(file) && !may_replace) Refuse(file, "is there already; --force replaces it");
}

void WriteTextFile(const fs::path& file, const std::string& text) {
  std::error_code ignored;  // the write below tells
  if (file.has_parent_path()) fs::create_directories(file.parent_path(), ignored);
  errno = 0;
  std::ofstream out(file, std::ios::binary);
  out << text;
  out.close();
  if (!out) FailToWrite(file);
}

}  // namespace sidestep
