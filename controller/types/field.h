// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// field: how a parameter struct tells its fields to readers, writers and documentation.
//
// A struct lists its fields once, in a static VisitFields(self, visit), where every line is
//   visit("key", self.key, Range{min, max}, "meaning")  a double, int or Vector3d (each entry)
//   visit("key", self.key, "meaning")                   anything else
// An enum is named by a specialisation of EnumNames. Bounds are in SI units, and the key ends in
// its unit. The meaning is one line; it stands nowhere else: `sidestep keys`, the JSON schema and
// scenarios/README.md print it.

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>

namespace sidestep {

/// Bounds of a number, or of each entry of a vector; inclusive unless told otherwise.
struct Range {
  double min;
  double max;
  bool excludes_min{false};  ///< min itself is out of range.
};

/// What a key means, in one line of plain English, and whether a file must have it.
struct Meaning {
  std::string_view text;
  bool is_required{false};

  /// A plain text means an optional key, so that tables hold nothing but texts.
  constexpr Meaning(const char* meaning) : text(meaning) {}  // NOLINT(google-explicit-constructor)
  constexpr Meaning(std::string_view meaning, bool required)
      : text(meaning), is_required(required) {}
};

/// The meaning of a key that has no default.
constexpr Meaning Required(std::string_view meaning) { return {meaning, true}; }

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

/// The enum's value of that name, or nothing.
template <typename Enum>
constexpr std::optional<Enum> EnumOfName(std::string_view name) {
  for (const auto& [value, known] : EnumNames<Enum>::kNames) {
    if (known == name) return value;
  }
  return std::nullopt;
}

/// Every value of a named enum, in the order of its names.
template <typename Enum>
constexpr auto EnumValues() {
  std::array<Enum, EnumNames<Enum>::kNames.size()> values{};
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = EnumNames<Enum>::kNames[i].first;
  return values;
}

/// The SI unit that a name ends in, as text: `rate_hz` gives "Hz", `step_s` "s", `mpc` "". Names of
/// keys, metrics and columns share the endings.
constexpr std::string_view UnitOf(std::string_view name) {
  // An ending that contains another comes before it.
  constexpr std::array<std::pair<std::string_view, std::string_view>, 25> kEndings{
      {{"_Nms_per_rad", "N m s/rad"},
       {"_Nm_per_rad", "N m/rad"},
       {"_radps_per_Nm", "rad/s/(N m)"},
       {"_mps_per_N", "m/s/N"},
       {"_N_per_m", "N/m"},
       {"_per_s2", "1/s^2"},
       {"_per_s", "1/s"},
       {"_per_N2", "1/N^2"},
       {"_Nspkg", "N s/kg"},
       {"_mg", "m g"},
       {"_kgm2ps", "kg m^2/s"},
       {"_radps", "rad/s"},
       {"_mps2", "m/s^2"},
       {"_mps", "m/s"},
       {"_rad", "rad"},
       {"_ms", "ms"},
       {"_Nm", "N m"},
       {"_Ns", "N s"},
       {"_kg", "kg"},
       {"_hz", "Hz"},
       {"_px", "px"},
       {"_N", "N"},
       {"_J", "J"},
       {"_m", "m"},
       {"_s", "s"}}};
  for (const auto& [ending, unit] : kEndings) {
    if (name.ends_with(ending)) return unit;
  }
  return "";
}

}  // namespace sidestep
