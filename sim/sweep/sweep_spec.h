// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// sweep_spec: what a sweep is asked to find out, as plain data.
//
// A ray is one combination of controller and axes. Along it either one run a seed is made, or, with
// a `limit`, runs of rising strength. A cell is one run: a ray, a strength and a seed.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "sim/sweep/axis.h"

namespace sidestep {

/// A named set of overrides, for comparing controllers.
struct ControllerSpec {
  std::string name;
  std::vector<std::string> set;  ///< Assignments `a.b=c`.
};

/// The key along which the limit of survival is looked for.
struct LimitSpec {
  std::string key;
  std::vector<double> ladder;  ///< Ascending, above 0: the strengths that are tried anyway.
  double resolution{0.0};      ///< Bisection ends when the bracket is no wider; above 0.
};

struct SweepSpec {
  std::string name;
  std::filesystem::path scenario;  ///< Absolute.
  std::vector<std::string> set;    ///< Assignments for all cells.
  std::vector<Axis> axes;          ///< But that of the limit.
  std::optional<LimitSpec> limit;
  std::vector<ControllerSpec> controllers;  ///< At least one; `default` without overrides.
  std::vector<std::uint64_t> seeds;         ///< Empty: the scenario's own.
  std::uint64_t sample_seed{1};             ///< Of random and latin axes.
};

}  // namespace sidestep
