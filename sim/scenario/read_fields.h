// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// read_fields: reads any struct that lists its fields with VisitFields (controller/types/field.h).

#include <Eigen/Core>
#include <cctype>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "controller/types/field.h"
#include "models/support/config_error.h"
#include "models/support/config_node.h"
#include "sim/scenario/scenario.h"

namespace sidestep {

/// Declared ahead: a struct may hold a struct, which FieldReader reads by this again.
template <typename T>
void ReadFields(const ConfigNode& node, T& value);

/// Does `read` with every element of a list; what is wrong with them is told together.
template <typename Read>
void ForEachElement(const ConfigNode& list, const Read& read) {
  Mistakes mistakes;
  for (const ConfigNode& element : list.List()) {
    mistakes.Try([&] { read(element); });
  }
  mistakes.Throw();
}

/// The value of an enum by its name in EnumNames. Throws ConfigError listing them otherwise.
template <typename Enum>
Enum ReadEnum(const ConfigNode& node) {
  std::vector<std::string> names;
  for (const auto& entry : EnumNames<Enum>::kNames) names.emplace_back(entry.second);
  return EnumNames<Enum>::kNames[node.Choice(names)].first;
}

/// The visitor: overwrites every field whose key the map has; others keep their default. Throws
/// ConfigError if a required key is missing.
class FieldReader {
 public:
  /// `map` must outlive the reader, and notes each key that is asked for.
  explicit FieldReader(ConfigMap* map) : map_(map) {}

  /// A finite number; `range` says whether its lower end belongs to it.
  void operator()(const char* key, double& field, Range range, Meaning meaning) {
    const auto node = Find(key, meaning);
    if (!node) return;
    field = node->Number(range.min, range.max);
    if (range.excludes_min && field <= range.min) {
      node->Fail("must be greater than " + NumberText(range.min));
    }
  }

  /// Written without fraction or exponent.
  void operator()(const char* key, int& field, Range range, Meaning meaning) {
    if (const auto node = Find(key, meaning)) field = ReadInt(*node, range);
  }

  /// Three numbers, each within `range`.
  void operator()(const char* key, Eigen::Vector3d& field, Range range, Meaning meaning) {
    if (const auto node = Find(key, meaning)) field = node->Vector3(range.min, range.max);
  }

  /// Two even integers, each within `range`.
  void operator()(const char* key, PixelSize& field, Range range, Meaning meaning) {
    const auto node = Find(key, meaning);
    if (!node) return;
    const std::vector<ConfigNode> sides = node->List();
    if (sides.size() != 2) node->Fail("must be a list of 2 integers, [width, height] in pixels");
    field = {ReadSide(sides[0], range), ReadSide(sides[1], range)};
  }

  /// A value without a default: stays empty where the map has no such key.
  template <typename T>
  void operator()(const char* key, std::optional<T>& field, Range range, Meaning meaning) {
    if (!Find(key, meaning)) return;
    field.emplace();
    (*this)(key, *field, range, meaning);
  }

  /// A named value without a default, likewise.
  template <typename T>
  void operator()(const char* key, std::optional<T>& field, Meaning meaning) {
    if (!Find(key, meaning)) return;
    field.emplace();
    (*this)(key, *field, meaning);
  }

  /// A number within `range`, or a name.
  void operator()(const char* key, StridePhase& field, Range range, Meaning meaning) {
    const auto node = Find(key, meaning);
    if (!node) return;
    const std::string& text = node->tree().scalar;
    const bool is_name = !text.empty() && std::isalpha(static_cast<unsigned char>(text[0])) != 0;
    if (is_name) {
      field.name = ReadEnum<PhaseName>(*node);
    } else {
      field.share = node->Number(range.min, range.max);
    }
  }

  /// Only up to 2^63 - 1: YAML's integers are read as signed ones.
  void operator()(const char* key, std::uint64_t& field, Meaning meaning) {
    const auto node = Find(key, meaning);
    if (!node) return;
    constexpr std::int64_t kMax = std::numeric_limits<std::int64_t>::max();
    field = static_cast<std::uint64_t>(node->Integer(0, kMax));
  }

  /// A list of structs with fields of their own; an element starts from the defaults.
  template <typename T>
  void operator()(const char* key, std::vector<T>& field, Meaning meaning) {
    const std::optional<ConfigNode> node = Find(key, meaning);
    if (!node) return;
    field.clear();
    ForEachElement(*node,
                   [&](const ConfigNode& element) { ReadFields(element, field.emplace_back()); });
  }

  /// Truth values, texts, enums by name; anything else is a struct with fields of its own and is
  /// read into its present values, so that a file may set one key of it.
  template <typename T>
  void operator()(const char* key, T& field, Meaning meaning) {
    const std::optional<ConfigNode> node = Find(key, meaning);
    if (!node) return;
    if constexpr (std::is_same_v<T, bool>) {
      field = node->Bool();
    } else if constexpr (std::is_same_v<T, std::string>) {
      field = node->Text();
    } else if constexpr (std::is_enum_v<T>) {
      field = ReadEnum<T>(*node);
    } else {
      ReadFields(*node, field);
    }
  }

 protected:
  /// The value of `key`; nothing if the map lacks it and may. Throws ConfigError if it must not.
  std::optional<ConfigNode> Find(const char* key, Meaning meaning) {
    if (meaning.is_required) return map_->Required(key);
    return map_->Optional(key);
  }

 private:
  /// Bounds of a Range are doubles; those of integers are whole numbers.
  static int ReadInt(const ConfigNode& node, Range range) {
    return static_cast<int>(
        node.Integer(static_cast<std::int64_t>(range.min), static_cast<std::int64_t>(range.max)));
  }

  static int ReadSide(const ConfigNode& node, Range range) {
    const int side_px = ReadInt(node, range);
    if (side_px % 2 != 0) node.Fail("= " + node.Text() + " must be even, as H.264 asks");
    return side_px;
  }

  ConfigMap* map_;
};

/// A FieldReader that goes on after a mistake, and keeps it.
class PatientFieldReader {
 public:
  PatientFieldReader(ConfigMap* map, Mistakes* mistakes) : reader_(map), mistakes_(mistakes) {}

  template <typename T, typename... Rest>
  void operator()(const char* key, T& field, const Rest&... rest) {
    mistakes_->Try([&] { reader_(key, field, rest...); });
  }

 private:
  FieldReader reader_;
  Mistakes* mistakes_;
};

/// Reads a map into `value`, whose fields' present values are the defaults. Throws ConfigError on
/// wrong types, values out of range and unknown keys, all of them, each at its place.
template <typename T>
void ReadFields(const ConfigNode& node, T& value) {
  ConfigMap map = node.Map();
  Mistakes mistakes;
  T::VisitFields(value, PatientFieldReader(&map, &mistakes));
  mistakes.Try([&] { map.RejectUnknownKeys(); });
  mistakes.Throw();
}

}  // namespace sidestep
