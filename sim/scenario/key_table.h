// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// key_table: every key that a scenario may have, as plain data.
//
// In : the VisitFields tables.     Out: a tree of keys with kind, bounds, default and meaning.
// Flow: VisitFields -> [key_table] -> key_text (`sidestep keys`), scenario_schema (JSON Schema).

#include <optional>
#include <string>
#include <vector>

namespace sidestep {

/// What a key's value looks like in a file.
enum class KeyKind {
  kNumber,
  kInteger,
  kVector,     ///< A list of three numbers, each within the bounds.
  kPixelSize,  ///< A list of two even integers, each within the bounds.
  kBool,
  kText,
  kChoice,          ///< One of `choices`.
  kNumberOrChoice,  ///< A number within the bounds, or one of `choices`.
  kMap,             ///< A map of `children`.
  kMapOrList,       ///< Such a map, or a list of at least one of them.
  kList,            ///< A list of such maps; may be empty.
  kPushes,      ///< A list of maps that tell a force and a start in one of some ways; may be empty.
  kMapOrBool,   ///< Such a map, or true or false.
  kMetricsMap,  ///< A map from metrics to what is expected of them.
};

/// One key with all that a user may ask about it.
struct KeyInfo {
  std::string name;  ///< Within its map.
  KeyKind kind{KeyKind::kMap};
  std::optional<double> min;  ///< SI; of each entry of a list of numbers.
  std::optional<double> max;
  bool excludes_min{false};  ///< min itself is out of range.
  std::vector<std::string> choices;
  bool is_required{false};
  std::string default_value;      ///< As a file would spell it; empty if there is none.
  std::string meaning;            ///< One line.
  std::vector<KeyInfo> children;  ///< Of maps, in the order of the tables.

  /// Whether the value is a map of keys of its own, or a list of such maps.
  bool has_children() const { return !children.empty(); }
};

/// The scenario itself: a map whose children are the keys at the top of a file. Defaults are the
/// program's; a robot's `control:` block may replace those of `control`.
KeyInfo ScenarioKeys();

/// The key at a dotted path as `--set` or KeyPath spells it (`pushes.0.start_s`,
/// `pushes[].start_s`), or the root if it is empty. Throws ConfigError that names the nearest key.
const KeyInfo& FindKey(const KeyInfo& root, const std::string& path);

/// `path` of a key below `parent`: `control` and `mpc` give `control.mpc`, `pushes` and `body` give
/// `pushes[].body`.
std::string KeyPath(const std::string& parent_path, const KeyInfo& parent, const KeyInfo& key);

}  // namespace sidestep
