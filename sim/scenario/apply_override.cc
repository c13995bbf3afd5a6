// SPDX-License-Identifier: BSD-3-Clause
#include "sim/scenario/apply_override.h"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "sim/scenario/push_option.h"

namespace sidestep {
namespace {

std::vector<std::string> PartsOf(const std::string& path, const ConfigPlace& place) {
  std::vector<std::string> parts;
  std::size_t start = 0;
  while (start <= path.size()) {
    const std::size_t dot = std::min(path.find('.', start), path.size());
    parts.push_back(path.substr(start, dot - start));
    if (parts.back().empty()) FailAt(place, "'" + path + "' is no dotted path of keys");
    start = dot + 1;
  }
  return parts;
}

ConfigTree* Element(ConfigTree* list, const std::string& part, const std::string& path,
                    const ConfigPlace& place) {
  std::size_t index = 0;
  const char* const end = part.data() + part.size();
  const auto [stop, error] = std::from_chars(part.data(), end, index);
  const std::size_t size = list->children.size();
  if (error == std::errc::invalid_argument || stop != end) {
    FailAt(place, path + " is a list; '" + part + "' is no index of it");
  }
  if (error != std::errc() || index >= size) {
    FailAt(place, path + " has no element " + part + "; it has " + std::to_string(size) +
                      (size == 1 ? " element" : " elements"));
  }
  return &list->children[index];
}

/// The value of `key`, added as an empty one if the map lacks it.
ConfigTree* Value(ConfigTree* map, const std::string& key, const ConfigPlace& place) {
  if (ConfigTree* value = map->Find(key)) return value;
  map->keys.push_back({key, place});
  map->children.emplace_back();
  map->children.back().place = place;
  return &map->children.back();
}

/// Keys of a push of which the file's give way to another that an override sets: they tell the same
/// thing.
const std::vector<std::vector<std::string>>& RivalsInPush() {
  static const std::vector<std::vector<std::string>> kRivals{
      {"force_N", "magnitude_N", "magnitude_mg", "impulse_Nspkg"}, {"start_s", "at_phase"}};
  return kRivals;
}

bool Has(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Takes out of `push` what the file says and `key` now says in another way.
void RemoveRivals(const std::string& key, ConfigTree* push) {
  for (const std::vector<std::string>& rivals : RivalsInPush()) {
    if (!Has(rivals, key)) continue;
    for (std::size_t i = push->keys.size(); i-- > 0;) {
      const std::string& name = push->keys[i].text;
      // Where a push starts by the clock, the rest of what its phase was goes too.
      const bool is_of_phase = key == "start_s" && (name == "foot" || name == "after_s");
      const bool is_rival = (Has(rivals, name) && name != key) || is_of_phase;
      if (!is_rival || !push->children[i].place.source->is_file) continue;
      push->keys.erase(push->keys.begin() + static_cast<std::ptrdiff_t>(i));
      push->children.erase(push->children.begin() + static_cast<std::ptrdiff_t>(i));
    }
  }
}

}  // namespace

void ApplyOverride(const std::string& assignment, ConfigTree* root, const NoteSink& note) {
  if (assignment.starts_with(kPushOption)) {
    AddPush(assignment.substr(kPushOption.size()), root);
    return;
  }
  const ConfigSource source{"--set " + assignment, false};
  const ConfigPlace place{std::make_shared<const ConfigSource>(source), 1, 1};
  const std::size_t equals = assignment.find('=');
  if (equals == std::string::npos) FailAt(place, "must read key=value");
  ConfigTree value = ParseConfig(assignment.substr(equals + 1), source);

  const std::string assigned = RenamedPath(assignment.substr(0, equals), place, note);
  ConfigTree* tree = root;
  std::string path;
  const std::vector<std::string> parts = PartsOf(assigned, place);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::string& part = parts[i];
    if (tree->kind == ConfigKind::kNull) tree->kind = ConfigKind::kMap;
    if (tree->kind == ConfigKind::kScalar) {
      FailAt(place, path + " is '" + tree->scalar + "', which has no '" + part + "'");
    }
    const bool is_list = tree->kind == ConfigKind::kList;
    const bool is_of_push = i == 2 && parts.size() == 3 && parts[0] == "pushes";
    if (is_of_push && tree->kind == ConfigKind::kMap) RemoveRivals(part, tree);
    tree = is_list ? Element(tree, part, path, place) : Value(tree, part, place);
    path += (path.empty() ? "" : ".") + part;
  }
  *tree = std::move(value);
  RenameOldKeys(root, note);
}

}  // namespace sidestep
