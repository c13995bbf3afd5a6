// SPDX-License-Identifier: BSD-3-Clause
#include "sim/scenario/apply_override.h"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

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
  const auto found = std::find_if(map->keys.begin(), map->keys.end(),
                                  [&](const ConfigKey& known) { return known.text == key; });
  if (found != map->keys.end())
    return &map->children[static_cast<std::size_t>(found - map->keys.begin())];
  map->keys.push_back({key, place});
  map->children.emplace_back();
  map->children.back().place = place;
  return &map->children.back();
}

}  // namespace

void ApplyOverride(const std::string& assignment, ConfigTree* root, const NoteSink& note) {
  const ConfigSource source{"--set " + assignment, false};
  const ConfigPlace place{std::make_shared<const ConfigSource>(source), 1, 1};
  const std::size_t equals = assignment.find('=');
  if (equals == std::string::npos) FailAt(place, "must read key=value");
  ConfigTree value = ParseConfig(assignment.substr(equals + 1), source);

  const std::string assigned = RenamedPath(assignment.substr(0, equals), place, note);
  ConfigTree* tree = root;
  std::string path;
  for (const std::string& part : PartsOf(assigned, place)) {
    if (tree->kind == ConfigKind::kNull) tree->kind = ConfigKind::kMap;
    if (tree->kind == ConfigKind::kScalar) {
      FailAt(place, path + " is '" + tree->scalar + "', which has no '" + part + "'");
    }
    const bool is_list = tree->kind == ConfigKind::kList;
    tree = is_list ? Element(tree, part, path, place) : Value(tree, part, place);
    path += (path.empty() ? "" : ".") + part;
  }
  *tree = std::move(value);
  RenameOldKeys(root, note);
}

}  // namespace sidestep
