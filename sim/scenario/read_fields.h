// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// read_fields: reads any struct that lists its fields with VisitFields (controller/types/field.h).

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "controller/types/field.h"
#include "models/support/config_node.h"

namespace sidestep {

template <typename T>
void ReadFields(const ConfigNode& node, T& value);

/// The value of an enum by its name in EnumNames. Throws ConfigError listing them otherwise.
template <typename Enum>
Enum ReadEnum(const ConfigNode& node) {
  std::vector<std::string> names;
  for (const auto& entry : EnumNames<Enum>::kNames) names.emplace_back(entry.second);
  return EnumNames<Enum>::kNames[node.Choice(names)].first;
}

/// The visitor: overwrites every field whose key the map has; others keep their default.
class FieldReader {
 public:
  explicit FieldReader(ConfigMap* map) : map_(map) {}

  void operator()(const char* key, double& field, Range range) {
    if (const auto node = map_->Optional(key)) field = node->Number(range.min, range.max);
  }

  void operator()(const char* key, int& field, Range range) {
    const auto node = map_->Optional(key);
    if (!node) return;
    field = static_cast<int>(
        node->Integer(static_cast<std::int64_t>(range.min), static_cast<std::int64_t>(range.max)));
  }

  void operator()(const char* key, Eigen::Vector3d& field, Range range) {
    if (const auto node = map_->Optional(key)) field = node->Vector3(range.min, range.max);
  }

  template <typename T>
  void operator()(const char* key, T& field) {
    const std::optional<ConfigNode> node = map_->Optional(key);
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

 private:
  ConfigMap* map_;
};

/// Reads a map into `value`, whose fields' present values are the defaults. Throws ConfigError on
/// a wrong type, a value out of range or an unknown key, at its place.
template <typename T>
void ReadFields(const ConfigNode& node, T& value) {
  ConfigMap map = node.Map();
  FieldReader reader(&map);
  T::VisitFields(value, reader);
  map.RejectUnknownKeys();
}

}  // namespace sidestep
