// SPDX-License-Identifier: BSD-3-Clause
#include "sim/scenario/based_on.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <system_error>
#include <utility>
#include <vector>

#include "models/support/config_node.h"
#include "models/support/nearest_name.h"
#include "sim/scenario/find_scenario.h"

namespace sidestep {
namespace {

namespace fs = std::filesystem;

constexpr std::int64_t kFormatVersion = 1;
constexpr std::size_t kMaxFiles = 8;  // More are a slip: nobody could say what such a file means.

fs::path FindBase(const ConfigNode& node, const fs::path& file) {
  const std::string word = node.Text();
  std::error_code ignored;
  const fs::path beside = file.parent_path() / word;
  if (fs::is_regular_file(beside, ignored)) return beside;
  const fs::path shipped = FindShippedScenario(word);
  if (!shipped.empty()) return shipped;
  node.Fail("= '" + word + "' is neither a file beside this one nor a scenario that ships; " +
            DidYouMean(word, ShippedScenarios(), "scenarios that ship"));
}

void RemoveKey(const std::string& key, ConfigTree* map) {
  const auto found = std::find_if(map->keys.begin(), map->keys.end(),
                                  [&](const ConfigKey& known) { return known.text == key; });
  if (found == map->keys.end()) return;
  map->children.erase(map->children.begin() + (found - map->keys.begin()));
  map->keys.erase(found);
}

void MergeOver(ConfigTree own, ConfigTree* base) {
  if (own.kind != ConfigKind::kMap || base->kind != ConfigKind::kMap) {
    *base = std::move(own);
    return;
  }
  base->place = own.place;
  for (std::size_t i = 0; i < own.keys.size(); ++i) {
    if (ConfigTree* value = base->Find(own.keys[i].text)) {
      base->keys[static_cast<std::size_t>(value - base->children.data())] = own.keys[i];
      MergeOver(std::move(own.children[i]), value);
    } else {
      base->keys.push_back(std::move(own.keys[i]));
      base->children.push_back(std::move(own.children[i]));
    }
  }
}

// `chain`: canonical paths of the files that lead here.
ConfigTree ReadChain(const fs::path& file, const NoteSink& note, std::vector<fs::path> chain) {
  std::error_code ignored;
  chain.push_back(fs::weakly_canonical(file, ignored));
  ConfigTree own = ReadConfigFile(file);
  RenameOldKeys(&own, note);
  ConfigMap map(own, "");
  const std::optional<ConfigNode> word = map.Optional(BasedOn::kKey);
  if (!word) {
    if (chain.size() > 1) CheckFormat(own, &map);  // a file alone is checked as it is read
    return own;
  }
  CheckFormat(own, &map);
  map.Required("name");
  const fs::path base_file = FindBase(*word, file);
  if (std::count(chain.begin(), chain.end(), fs::weakly_canonical(base_file, ignored)) != 0) {
    word->Fail("= '" + word->Text() + "' leads back to " + base_file.string());
  }
  if (chain.size() == kMaxFiles) {
    word->Fail("makes a chain of more than " + std::to_string(kMaxFiles) + " files");
  }
  ConfigTree merged = ReadChain(base_file, note, std::move(chain));
  RemoveKey("name", &merged);
  if (own.Find("expect") != nullptr) RemoveKey("expect", &merged);
  RemoveKey(BasedOn::kKey, &own);
  MergeOver(std::move(own), &merged);
  return merged;
}

}  // namespace

void CheckFormat(const ConfigTree& root, ConfigMap* map) {
  if (root.Find(kSweepKey) != nullptr) {
    FailAt(root.place, "is a sweep's file, no scenario's; sidestep sweep runs it");
  }
  const ConfigNode version = map->Required("sidestep");
  if (version.Integer(0, std::numeric_limits<std::int32_t>::max()) != kFormatVersion) {
    version.Fail("= " + version.Text() + " is a format that this program can't read; it reads 1");
  }
}

ConfigTree ReadWithBases(const fs::path& file, const NoteSink& note) {
  return ReadChain(file, note, {});
}

}  // namespace sidestep
