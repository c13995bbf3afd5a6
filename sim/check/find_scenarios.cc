// SPDX-License-Identifier: BSD-3-Clause
#include "sim/check/find_scenarios.h"

#include <algorithm>
#include <map>

#include "models/support/config_error.h"
#include "sim/scenario/find_scenario.h"

namespace sidestep {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> YamlFilesIn(const fs::path& folder, SweepFiles sweeps) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file() || entry.path().extension() != ".yaml") continue;
    if (sweeps == SweepFiles::kSkipped && IsSweepFile(entry.path())) continue;
    files.push_back(entry.path());
  }
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
