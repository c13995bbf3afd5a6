// SPDX-License-Identifier: BSD-3-Clause
#include "sim/apps/commands/out_folder.h"

#include <array>
#include <fstream>
#include <system_error>

#include "models/support/config_error.h"

namespace sidestep {
namespace {

namespace fs = std::filesystem;

constexpr const char* kRunMark = "scenario.yaml";
constexpr const char* kThinnedFile = "trajectory_thinned.csv";  // in plots/
constexpr std::array<const char*, 8> kRunFiles{"trajectory.csv", "footsteps.csv", "mpc.csv",
                                               "states.bin",     "summary.json",  "video.mp4",
                                               "report.html",    kRunMark};

[[noreturn]] void Refuse(const fs::path& folder, const std::string& why) {
  throw ConfigError(folder.string() + ": error: " + why);
}

// The mark goes last, so that a folder whose removal was cut short is still a run's.
void RemoveRun(const fs::path& folder) {
  const fs::path plots = folder / "plots";
  if (fs::is_directory(plots)) {
    for (const auto& entry : fs::directory_iterator(plots)) {
      const fs::path file = entry.path();
      const bool is_ours = file.extension() == ".svg" || file.extension() == ".png" ||
                           file.extension() == ".gp" || file.filename() == kThinnedFile;
      if (is_ours) fs::remove(file);
    }
    if (fs::is_empty(plots)) fs::remove(plots);
  }
  for (const char* file : kRunFiles) fs::remove(folder / file);
}

}  // namespace

void CheckOutFolder(const fs::path& folder, bool may_replace) {
  if (!fs::exists(folder)) return;
  if (!fs::is_directory(folder)) Refuse(folder, "is not a folder");
  if (fs::is_empty(folder)) return;
  if (!may_replace) Refuse(folder, "the output folder is not empty; --force replaces a run in it");
  if (!fs::exists(folder / kRunMark)) {
    Refuse(folder, "holds no run (no scenario.yaml) but other files; --force replaces only runs");
  }
}

void PrepareOutFolder(const fs::path& folder, bool may_replace) {
  try {
    CheckOutFolder(folder, may_replace);
    fs::create_directories(folder);
    RemoveRun(folder);
  } catch (const fs::filesystem_error& error) {
    Refuse(folder, "can't be used as the output folder: " + error.code().message());
  }
}

void RequireRunFolder(const fs::path& folder) {
  if (!fs::is_directory(folder)) Refuse(folder, "is not a folder");
  if (!fs::exists(folder / kRunMark)) Refuse(folder, "is not a run's folder (no scenario.yaml)");
}

void WriteTextFile(const fs::path& file, const std::string& text) {
  std::error_code ignored;  // the write below tells
  if (file.has_parent_path()) fs::create_directories(file.parent_path(), ignored);
  std::ofstream out(file, std::ios::binary);
  out << text;
  out.close();
  if (!out) Refuse(file, "can't be written");
}

}  // namespace sidestep
