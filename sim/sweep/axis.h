// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// axis: one key of a scenario and the values that a sweep gives it.
//
// The grammar, of a file's value and of what follows `--vary key=`:
//   a:b:n           n values, evenly from a to b, both included (n >= 2). Of an angle (`_rad`) over
//   a
//                   whole turn the last one is left out: it is the first again
//   a:b:step=s      a, a + s, ... up to b
//   a:b:random=n    n values drawn uniformly
//   a:b:latin=n     n values, one in each n-th of the range: with the other `latin` axes of the
//                   sweep, a Latin hypercube
//   [v, w, ...]     these values: numbers, words, lists
// A number may be a multiple of pi: 2pi, pi/2, -3pi/4. The third part is always a count unless it
// says `step=`.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "models/support/config_tree.h"

namespace sidestep {

/// How the values of an axis combine with those of the others.
enum class AxisKind {
  kGrid,    ///< Each with each.
  kRandom,  ///< Drawn; the i-th with the i-th of every other random axis.
  kLatin    ///< Likewise among the axes of a Latin hypercube.
};

struct Axis {
  std::string key;   ///< Dotted path as `--set` spells it.
  std::string text;  ///< The values as the user spelled them.
  AxisKind kind{AxisKind::kGrid};
  std::vector<std::string> values;  ///< Of a grid: YAML, as what follows `--set key=`.
  double min{0.0};                  ///< Of the others: the range and how many values.
  double max{0.0};
  int count{0};

  std::size_t size() const {
    return kind == AxisKind::kGrid ? values.size() : static_cast<std::size_t>(count);
  }
};

/// A plain number or a multiple of pi; nothing if it is neither.
std::optional<double> ParseNumber(const std::string& text);

/// Reads the values of `key`. Throws ConfigError at the value's place: `<key> ...`.
Axis ReadAxis(const std::string& key, const ConfigTree& value);

/// The same of a command line's `key=values`; errors begin with `option key=values: `.
Axis ParseAxis(const std::string& option, const std::string& assignment);

/// `value` as YAML on one line, as `--set key=` takes it.
std::string FlowText(const ConfigTree& value);

/// Throws ConfigError at `place` unless `key` is one that a scenario may have; names the nearest.
void CheckKey(const std::string& key, const ConfigPlace& place);

/// The values of `axes` of one `kind` that is drawn, one row a draw, a column an axis; nothing if
/// there is none. They depend on nothing but the axes and the seed.
std::vector<std::vector<double>> DrawAxes(const std::vector<Axis>& axes, AxisKind kind,
                                          std::uint64_t seed);

}  // namespace sidestep
