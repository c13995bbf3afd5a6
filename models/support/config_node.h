// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// config_node: strict reading of a ConfigTree, one typed value at a time.
//
// Every error reads `file:line:column: error: <path> <what>`, where path is dotted with list
// elements by index (`pushes.0.start_s`), as `--set` spells it. Both classes are views: the tree
// must outlive them.

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "models/support/config_tree.h"

namespace sidestep {

class ConfigMap;

/// One value with its path. Every reader throws ConfigError if the value is something else.
class ConfigNode {
 public:
  ConfigNode(const ConfigTree& tree, std::string path) : tree_(&tree), path_(std::move(path)) {}

  const std::string& path() const { return path_; }
  const ConfigTree& tree() const { return *tree_; }

  /// A finite number with min <= number <= max. Quoted text is no number.
  double Number(double min, double max) const;

  /// An integer within inclusive bounds, written without fraction or exponent.
  std::int64_t Integer(std::int64_t min, std::int64_t max) const;

  /// `true` or `false`.
  bool Bool() const;

  /// Whether the value is spelled `true` or `false`.
  bool is_bool() const;

  /// Any scalar as text; may be empty only if it was quoted.
  std::string Text() const;

  /// A name that this file gives to something: a plain word (plain_word.h).
  std::string Word() const;

  /// Index of the value in `names`.
  std::size_t Choice(std::span<const std::string> names) const;

  /// A list of exactly three numbers within inclusive bounds.
  Eigen::Vector3d Vector3(double min, double max) const;

  /// Elements of a list, with paths `path.0`, `path.1`, ...
  std::vector<ConfigNode> List() const;

  /// The value as a map.
  ConfigMap Map() const;

  /// Throws ConfigError at the value's place: `<path> <what>`.
  [[noreturn]] void Fail(const std::string& what) const;

 private:
  const ConfigTree* tree_;
  std::string path_;
};

/// A map that remembers which keys were asked for, so that the rest can be refused.
class ConfigMap {
 public:
  /// Throws ConfigError if `tree` is no map.
  ConfigMap(const ConfigTree& tree, const std::string& path);

  /// The value of `key`; throws ConfigError if it is missing, naming a key that looks like it.
  ConfigNode Required(const std::string& key);

  /// The value of `key`, or nothing.
  std::optional<ConfigNode> Optional(const std::string& key);

  /// Every key of a map whose keys are names, in the file's order.
  std::vector<std::string> Keys() const;

  /// Call after the last read: throws on keys that nobody asked for, all of them.
  void RejectUnknownKeys() const;

  /// Throws ConfigError at the place of the key itself, which must be present.
  [[noreturn]] void FailAtKey(const std::string& key, const std::string& what) const;

  /// Throws ConfigError at the place where the map begins: `<path> <what>`.
  [[noreturn]] void Fail(const std::string& what) const;

 private:
  std::string PathOf(const std::string& key) const;

  const ConfigTree* tree_;
  std::string path_;
  std::vector<std::string> known_;
};

/// The value at a dotted path, or null.
const ConfigTree* FindPath(const ConfigTree& root, const std::string& path);

/// Throws ConfigError `<path> <what>`, at the value's place or, where the file leaves it to its
/// default, at that of the innermost part of the path that the file has.
[[noreturn]] void FailAtPath(const ConfigTree& root, const std::string& path,
                             const std::string& what);

/// Shortest decimal that reads back as the same double.
std::string NumberText(double value);

}  // namespace sidestep
