// SPDX-License-Identifier: BSD-3-Clause
#include "sim/scenario/renamed_keys.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>

namespace sidestep {
namespace {

/// A key that had another name once.
struct RenamedKey {
  std::string_view map;  ///< The key at the top of the file under which it stands.
  std::string_view old_name;
  std::string_view new_name;

  std::string OldPath() const { return std::string(map) + "." + std::string(old_name); }
  std::string NewPath() const { return std::string(map) + "." + std::string(new_name); }
};

constexpr std::array kRenamedKeys{RenamedKey{"control", "wbc", "inverse_dynamics"},
                                  RenamedKey{"control", "position", "inverse_kinematics"}};

/// A key whose value means something else by now, so that its new name alone would not do.
struct ReplacedKey {
  std::string_view block;  ///< Under `control`.
  std::string_view name;
  std::string_view instead;

  std::string Path() const { return "control." + std::string(block) + "." + std::string(name); }
  std::string What() const { return Path() + " is now " + std::string(instead); }
};

constexpr std::array kReplacedKeys{
    ReplacedKey{"inverse_dynamics", "force_weight",
                "planned_force_weight, of shares of the robot's weight: the old value, which was "
                "per N^2, times (mass * 9.81)^2"}};

void Tell(const RenamedKey& renamed, const ConfigPlace& place, const NoteSink& note) {
  if (note) note(MessageAt(place, "note", renamed.OldPath() + " is now " + renamed.NewPath()));
}

/// The value of a key, or null.
ConfigTree* FindValue(ConfigTree* map, std::string_view key) {
  for (std::size_t i = 0; i < map->keys.size(); ++i) {
    if (map->keys[i].text == key) return &map->children[i];
  }
  return nullptr;
}

void RejectReplacedKeys(ConfigTree* root) {
  ConfigTree* control = FindValue(root, "control");
  for (const ReplacedKey& replaced : kReplacedKeys) {
    const ConfigTree* block = control == nullptr ? nullptr : FindValue(control, replaced.block);
    if (block == nullptr) continue;
    for (const ConfigKey& key : block->keys) {
      if (key.text == replaced.name) FailAt(key.place, replaced.What());
    }
  }
}

}  // namespace

void RenameOldKeys(ConfigTree* root, const NoteSink& note) {
  for (const RenamedKey& renamed : kRenamedKeys) {
    ConfigTree* map = FindValue(root, renamed.map);
    if (map == nullptr) continue;
    const auto old = std::find_if(map->keys.begin(), map->keys.end(), [&](const ConfigKey& key) {
      return key.text == renamed.old_name;
    });
    if (old == map->keys.end()) continue;
    if (map->Find(renamed.new_name) != nullptr) {
      FailAt(old->place, renamed.OldPath() + " is the old name of " + renamed.NewPath() +
                             ", which is given too");
    }
    Tell(renamed, old->place, note);
    old->text = renamed.new_name;
  }
  RejectReplacedKeys(root);
}

std::string RenamedPath(const std::string& path, const ConfigPlace& place, const NoteSink& note) {
  for (const RenamedKey& renamed : kRenamedKeys) {
    const std::string old_path = renamed.OldPath();
    if (path != old_path && !path.starts_with(old_path + ".")) continue;
    Tell(renamed, place, note);
    return RenamedPath(renamed.NewPath() + path.substr(old_path.size()), place, note);
  }
  for (const ReplacedKey& replaced : kReplacedKeys) {
    if (path == replaced.Path()) FailAt(place, replaced.What());
  }
  return path;
}

}  // namespace sidestep
