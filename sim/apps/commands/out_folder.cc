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

bool IsPlotFile(const fs::path& file) {
  return file.extension() == ".svg" || file.extension() == ".png" || file.extension() == ".gp" ||
         file.filename() == kThinnedFile;
}

bool IsProblemFile(const fs::path& file) {
  return file.extension() == ".json" && file.filename().string().starts_with("mpc_");
}

void RemoveFrom(const fs::path& subfolder, bool (*is_ours)(const fs::path&)) {
  if (!fs::is_directory(subfolder)) return;
  for (const auto& entry : fs::directory_iterator(subfolder)) {
    if (is_ours(entry.path())) fs::remove(entry.path());
  }
  if (fs::is_empty(subfolder)) fs::remove(subfolder);
}

// The mark goes last, so that a folder whose removal was cut short is still a run's.
void RemoveRun(const fs::path& folder) {
  RemoveFrom(folder / "plots", IsPlotFile);
  RemoveFrom(folder / "problems", IsProblemFile);
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

void CheckOutFile(const fs::path& file, bool may_replace) {
  if (fs::is_directory(file)) Refuse(file, "is a folder");
  if (!fs::is_directory(fs::absolute(file).parent_path())) Refuse(file, "its folder is not there");
  if (fs::exists(file) && !may_replace) Refuse(file, "is there already; --force replaces it");
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
