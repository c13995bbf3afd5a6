// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "models/robot_description/robot_description.h"
#include "models/support/data_folder.h"

namespace sidestep {
namespace {

constexpr const char* kRobotFile = "robot.yaml";

/// Where a folder a robot lies.
std::filesystem::path ModelsFolder() { return DataFolder() / "models"; }

bool IsFile(const std::filesystem::path& path) {
  std::error_code ignored;
  return std::filesystem::is_regular_file(path, ignored);
}

}  // namespace

std::filesystem::path FindRobot(const std::string& robot,
                                const std::filesystem::path& relative_to) {
  if (robot.empty()) return {};
  const std::vector<std::string> shipped = ShippedRobots();
  if (std::find(shipped.begin(), shipped.end(), robot) != shipped.end()) {
    return ModelsFolder() / robot / kRobotFile;
  }
  const std::filesystem::path path = relative_to / robot;  // an absolute `robot` stands alone
  return IsFile(path) ? std::filesystem::absolute(path).lexically_normal()
                      : std::filesystem::path();
}

std::vector<std::string> ShippedRobots() {
  std::vector<std::string> names;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(ModelsFolder(), error)) {
    if (IsFile(entry.path() / kRobotFile)) names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace sidestep
