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

fs::path FindShippedScenario(const fs::path& name) {
  const std::string stem = (name.extension() == kExtension ? name.stem() : name).string();
  const std::vector<std::string> shipped = ShippedScenarios();
  const bool is_shipped = std::find(shipped.begin(), shipped.end(), stem) != shipped.end();
  return is_shipped ? ScenariosFolder() / (stem + kExtension) : fs::path();
}

fs::path FindScenario(const fs::path& word) {
  std::error_code ignored;
  if (fs::exists(word, ignored) && !fs::is_directory(word, ignored)) return word;
  const char* what = fs::is_directory(word, ignored) ? "is a folder" : "does not exist";
  if (word.has_parent_path()) throw ConfigError(word.string() + ": error: " + what);
  const fs::path shipped = FindShippedScenario(word);
  if (!shipped.empty()) return shipped;
  const std::string name = (word.extension() == kExtension ? word.stem() : word).string();
  throw ConfigError(word.string() + ": error: " + what + "; " +
                    DidYouMean(name, ShippedScenarios(), "scenarios that ship"));
}

bool IsSweepFile(const fs::path& file) { return IsConfigFileWith(kSweepKey, file); }

}  // namespace sidestep
