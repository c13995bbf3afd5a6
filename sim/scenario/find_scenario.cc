// SPDX-License-Identifier: BSD-3-Clause
#include "sim/scenario/find_scenario.h"

#include <algorithm>
#include <system_error>

#include "models/support/config_error.h"
#include "models/support/config_tree.h"
#include "models/support/data_folder.h"
#include "models/support/nearest_name.h"

namespace sidestep {
namespace {

namespace fs = std::filesystem;

constexpr const char* kExtension = ".yaml";

fs::path ScenariosFolder() { return DataFolder() / "scenarios"; }

}  // namespace

std::vector<std::string> ShippedScenarios() {
  std::vector<std::string> names;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(ScenariosFolder(), ignored)) {
    if (entry.path().extension() == kExtension) names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

fs::path FindScenario(const fs::path& word) {
  std::error_code ignored;
  if (fs::exists(word, ignored) && !fs::is_directory(word, ignored)) return word;
  const char* what = fs::is_directory(word, ignored) ? "is a folder" : "does not exist";
  if (word.has_parent_path()) throw ConfigError(word.string() + ": error: " + what);
  const std::string name = (word.extension() == kExtension ? word.stem() : word).string();
  const std::vector<std::string> shipped = ShippedScenarios();
  if (std::find(shipped.begin(), shipped.end(), name) != shipped.end()) {
    return ScenariosFolder() / (name + kExtension);
  }
  throw ConfigError(word.string() + ": error: " + what + "; " +
                    DidYouMean(name, shipped, "scenarios that ship"));
}

bool IsSweepFile(const fs::path& file) {
  try {
    return ReadConfigFile(file).Find(kSweepKey) != nullptr;
  } catch (const ConfigError&) {
    return false;
  }
}

}  // namespace sidestep
