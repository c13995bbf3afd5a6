// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// recorded_problems: the MPC's problems in tests/data/mpc, one folder a run or a push window.

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "controller/mpc/problem/ocp_json.h"

namespace sidestep::mpc {

inline std::filesystem::path RecordedFolder() {
  return std::filesystem::path(SIDESTEP_SOURCE_DIR) / "tests/data/mpc";
}

/// Names of the folders, sorted.
inline std::vector<std::string> RecordedFolders() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(RecordedFolder())) {
    if (entry.is_directory()) names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

/// The problem files of `folder`, sorted: the order in which they were solved.
inline std::vector<std::filesystem::path> ProblemFiles(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ".json") paths.push_back(entry.path());
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

inline CentroidalOcp ReadProblem(const std::filesystem::path& path) {
  std::ifstream file(path);
  return OcpFromJson(nlohmann::json::parse(file));
}

}  // namespace sidestep::mpc
