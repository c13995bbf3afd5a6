// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// field: how a parameter struct tells its fields to readers, writers and documentation.
//
// A struct lists its fields once, in a static VisitFields(self, visit), where every line is
//   visit("key", self.key, Range{min, max})   a double, int or Eigen::Vector3d (each entry)
//   visit("key", self.key)                    a bool, std::string, enum or nested struct
// An enum is named by a specialisation of EnumNames. Bounds are inclusive, in SI units.

#include <array>
#include <string_view>
#include <utility>

namespace sidestep {

/// Inclusive bounds of a number, or of each entry of a vector.
struct Range {
  double min;
  double max;
};

/// Specialise with `static constexpr std::array<std::pair<Enum, std::string_view>, n> kNames`.
template <typename Enum>
struct EnumNames;

/// The name of an enum's value as files spell it.
template <typename Enum>
constexpr std::string_view EnumName(Enum value) {
  for (const auto& [candidate, name] : EnumNames<Enum>::kNames) {
    if (candidate == value) return name;
  }
  return "?";
}

}  // namespace sidestep
