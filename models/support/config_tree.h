// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// config_tree: a YAML document as plain data in which every key and value knows its place.
//
// In : a file, or the text after `--set key=`.     Out: a tree of maps, lists and scalars.
// Flow: text -> [config_tree] -> overrides edit it -> config_node reads it strictly.
// yaml-cpp's own nodes share state when assigned and keep duplicate keys silently; here a tree is
// a value, a duplicate key is an error, and a replaced value keeps saying where it came from.

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace sidestep {

/// What a text was read from.
struct ConfigSource {
  std::string name;    ///< The file as the user named it, or the whole option (`--set a.b=c`).
  bool is_file{true};  ///< Options have no lines; their errors tell a column within the value.
};

/// Where a key or a value begins. Line and column count from 1.
struct ConfigPlace {
  std::shared_ptr<const ConfigSource> source;
  int line{1};
  int column{1};
};

/// `file:line:column: <kind>: what`, or `--set a.b=c: <kind>: what`.
std::string MessageAt(const ConfigPlace& place, std::string_view kind, const std::string& what);

/// Throws ConfigError: `file:line:column: error: what`, or `--set a.b=c: error: what`.
[[noreturn]] void FailAt(const ConfigPlace& place, const std::string& what);

struct ConfigKey {
  std::string text;
  ConfigPlace place;
};

enum class ConfigKind { kNull, kScalar, kList, kMap };

/// One value of the document.
struct ConfigTree {
  ConfigKind kind{ConfigKind::kNull};
  ConfigPlace place;                 ///< An empty value has its key's place.
  std::string scalar;                ///< kScalar only.
  bool is_quoted{false};             ///< Quoted scalars are text, never numbers.
  std::vector<ConfigKey> keys;       ///< kMap only, in the file's order, each once.
  std::vector<ConfigTree> children;  ///< Elements of a list; a map's values, one a key.

  /// The value of `key`, or null if this is no map or has no such key.
  const ConfigTree* Find(std::string_view key) const;
  ConfigTree* Find(std::string_view key);
};

/// Parses one YAML document. Throws ConfigError on syntax errors, duplicate or non-text keys, maps
/// of more than 1000 of them, aliases, explicit tags, control characters, bytes that are no UTF-8,
/// an empty text and more than one document.
ConfigTree ParseConfig(const std::string& text, const ConfigSource& source);

/// Reads and parses a file; also throws ConfigError if it can't be read or exceeds 1 MiB.
ConfigTree ReadConfigFile(const std::filesystem::path& file);

/// Whether `file` is one whose outermost map has `key`, which tells the kinds of files apart. False
/// of what can't be read: its own reader tells what is wrong with it.
bool IsConfigFileWith(const std::string& key, const std::filesystem::path& file);

}  // namespace sidestep
