// SPDX-License-Identifier: BSD-3-Clause
#include "sim/check/find_scenarios.h"

#include <algorithm>
#include <map>
#include <system_error>

#include "models/support/config_error.h"
#include "sim/record/run_files.h"
#include "sim/scenario/find_scenario.h"
#include "sim/scenario/read_scenario.h"

namespace sidestep {
namespace {

namespace fs = std::filesystem;

/// A folder that this program has written: a run's or a sweep's, which hold copies of what they
/// ran.
bool IsOurOutput(const fs::path& folder) {
  std::error_code ignored;
  return fs::exists(folder / kRunFilesName, ignored) ||
         fs::exists(folder / "trajectory.csv", ignored) ||
         (fs::exists(folder / "sweep.yaml", ignored) &&
          fs::exists(folder / "manifest.csv", ignored));
}

bool IsWanted(const fs::path& file, SweepFiles sweeps) {
  if (file.extension() != ".yaml" || IsRobotFile(file)) return false;
  return sweeps == SweepFiles::kFound || !IsSweepFile(file);
}

void AddYamlFilesIn(const fs::path& folder, SweepFiles sweeps, std::vector<fs::path>* files) {
  std::error_code failure;
  fs::directory_iterator entries(folder, failure);
  while (!failure && entries != fs::directory_iterator()) {
    const fs::directory_entry& entry = *entries;
    std::error_code ignored;  // what can't be looked at is no scenario
    if (entry.is_directory(ignored) && !entry.is_symlink(ignored)) {
      if (!IsOurOutput(entry.path())) AddYamlFilesIn(entry.path(), sweeps, files);
    } else if (entry.is_regular_file(ignored) && IsWanted(entry.path(), sweeps)) {
      files->push_back(entry.path());
    }
    entries.increment(failure);
  }
  if (failure) {
    throw ConfigError(folder.string() + ": error: can't be searched: " + failure.message());
  }
}

std::vector<fs::path> YamlFilesIn(const fs::path& folder, SweepFiles sweeps) {
  std::vector<fs::path> files;
  AddYamlFilesIn(folder, sweeps, &files);
  if (files.empty()) throw ConfigError(folder.string() + ": error: holds no scenario (*.yaml)");
  return files;
}

}  // namespace

std::vector<fs::path> FindScenarios(const std::vector<fs::path>& paths, SweepFiles sweeps) {
  std::map<fs::path, fs::path> as_given;  // canonical path -> the path to show
  for (const fs::path& path : paths) {
    const auto files = fs::is_directory(path) ? YamlFilesIn(path, sweeps)
                                              : std::vector<fs::path>{FindScenario(path)};
    for (const fs::path& file : files) as_given.emplace(fs::canonical(file), file);
  }
  std::vector<fs::path> files;
  for (const auto& [canonical, file] : as_given) files.push_back(file);
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace sidestep
