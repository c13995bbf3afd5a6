// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// yaml_writer: parameter structs as YAML text that reads back to the very same values.

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "controller/types/field.h"
#include "models/support/config_node.h"
#include "sim/scenario/scenario.h"

namespace sidestep {

/// `text` as a YAML scalar: plain where that is safe, else double-quoted with escapes.
std::string YamlScalar(std::string_view text);

/// `value` as a YAML float. The shortest form that reads back as the same double, but a power of
/// ten follows a point, as in 1.0e-06: readers of YAML 1.1 take 1e-06 for text.
std::string YamlNumber(double value);

/// `[x, y, z]`.
std::string YamlVector(const Eigen::Vector3d& value);

/// `[width, height]`.
std::string YamlSize(const PixelSize& size);

/// Appends block-style maps, two columns a level.
/// Numbers read back as the same double, so a dumped scenario gives the very run that it was dumped
/// from. Begin and End must pair; nothing checks it.
class YamlWriter {
 public:
  /// Writes `key: value`, where `value` is YAML already.
  void Line(std::string_view key, std::string_view value);

  /// Begins a map under `key`; End() ends it.
  void Begin(std::string_view key);
  void End() { --depth_; }

  /// Begins a list element that is a map: the next line carries the dash.
  void BeginElement();
  void EndElement() { --depth_; }

  /// Writes a list of structs with VisitFields.
  template <typename T>
  void List(std::string_view key, const std::vector<T>& elements) {
    if (elements.empty()) {
      Line(key, "[]");
      return;
    }
    Begin(key);
    for (const T& element : elements) {
      BeginElement();
      Fields(element);
      EndElement();
    }
    End();
  }

  /// Writes every field of a struct with VisitFields.
  template <typename T>
  void Fields(const T& value) {
    T::VisitFields(value, *this);
  }

  // The visitor's face.
  // Ranges and meanings are for readers and documentation.
  void operator()(const char* key, double value, Range /*range*/, Meaning /*meaning*/) {
    Line(key, YamlNumber(value));
  }
  void operator()(const char* key, int value, Range /*range*/, Meaning /*meaning*/) {
    Line(key, std::to_string(value));
  }
  void operator()(const char* key, const Eigen::Vector3d& value, Range /*range*/,
                  Meaning /*meaning*/) {
    Line(key, YamlVector(value));
  }
  void operator()(const char* key, const PixelSize& value, Range /*range*/, Meaning /*meaning*/) {
    Line(key, YamlSize(value));
  }
  /// Writes nothing where there is no value.
  template <typename T>
  void operator()(const char* key, const std::optional<T>& value, Range range, Meaning meaning) {
    if (value) (*this)(key, *value, range, meaning);
  }
  template <typename T>
  void operator()(const char* key, const std::optional<T>& value, Meaning meaning) {
    if (value) (*this)(key, *value, meaning);
  }
  void operator()(const char* key, const StridePhase& value, Range /*range*/, Meaning /*meaning*/) {
    Line(key, value.name ? std::string(EnumName(*value.name)) : YamlNumber(value.share));
  }
  void operator()(const char* key, std::uint64_t value, Meaning /*meaning*/) {
    Line(key, std::to_string(value));
  }
  template <typename T>
  void operator()(const char* key, const std::vector<T>& value, Meaning /*meaning*/) {
    List(key, value);
  }
  /// Truth values, texts, enums by name; anything else is a struct, as a map under its key.
  template <typename T>
  void operator()(const char* key, const T& value, Meaning /*meaning*/) {
    if constexpr (std::is_same_v<T, bool>) {
      Line(key, value ? "true" : "false");
    } else if constexpr (std::is_same_v<T, std::string>) {
      Line(key, YamlScalar(value));
    } else if constexpr (std::is_enum_v<T>) {
      Line(key, EnumName(value));
    } else {
      Begin(key);
      Fields(value);
      End();
    }
  }

  /// All that was written so far, each line ended.
  const std::string& text() const { return text_; }

 private:
  std::string text_;
  int depth_{0};          // maps that are open
  bool has_dash_{false};  // the next line begins a list element
};

}  // namespace sidestep
