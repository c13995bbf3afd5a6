// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// rays: the combinations of a sweep, and the walk along one.

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "sim/sweep/limit_search.h"
#include "sim/sweep/sweep_spec.h"

namespace sidestep {

/// One controller and one value of every axis.
struct Ray {
  std::size_t index{0};             ///< In the sweep's order: by controller, then the axes'.
  std::size_t controller{0};        ///< Number in SweepSpec::controllers.
  std::vector<std::string> values;  ///< One an axis, in their order; YAML.
};

/// Which run of a ray. Texts are as `--set` takes them; empty where the scenario's own value holds.
struct CellKey {
  std::size_t ray{0};
  std::string strength;
  std::string seed;
  SearchStage stage{SearchStage::kSingle};
};

/// What came of a run.
enum class CellOutcome {
  kRecovered,  ///< The metric `recovered` is true.
  kLost,       ///< It is not: it fell, or did not come back to its gait.
  kInvalid     ///< The run says nothing of the controller.
};

template <>
struct EnumNames<CellOutcome> {
  static constexpr std::array<std::pair<CellOutcome, std::string_view>, 3> kNames{
      {{CellOutcome::kRecovered, "RECOVERED"},
       {CellOutcome::kLost, "LOST"},
       {CellOutcome::kInvalid, "INVALID"}}};
};

/// How many rays and how many cells at most a sweep has; a double, for they may be very many.
double NumRays(const SweepSpec& spec);
double NumCells(const SweepSpec& spec);

/// All rays, in order of their index.
std::vector<Ray> RaysOf(const SweepSpec& spec);

/// The assignments that make the base scenario a cell, in order: those of the sweep, the controller
/// and the axes, the strength, the seed.
std::vector<std::string> OverridesOf(const SweepSpec& spec, const Ray& ray, const CellKey& cell);

/// The first cell that a ray asks for.
CellKey FirstCell(const SweepSpec& spec, const Ray& ray);

/// Asks `outcome_of` for the ray's cells, one after the other: for each strength that the search
/// wants, all seeds. Nothing ends the walk, which is then not complete. It asks the same again
/// whenever it gets the same answers, so that rows of an earlier run can stand for runs.
LimitResult WalkRay(const SweepSpec& spec, const Ray& ray,
                    const std::function<std::optional<CellOutcome>(const CellKey&)>& outcome_of);

}  // namespace sidestep
