// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// cell_row: what a sweep keeps of a run, one line of a table. These lines are the interface to all
// that is drawn or compared afterwards.
//
// Columns: ray, id, controller, one an axis (its key), strength (of the limit's key), stage, seed,
// outcome, reasons, impulse_Nspkg, every metric, simulated_s, cpu_s, wall_s, host. But for the last
// three, which tell of the machine, a cell's line is the same wherever and whenever it is run.

#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "sim/sweep/cell_result.h"
#include "sim/sweep/rays.h"

namespace sidestep {

// A row's columns: ray, id and controller, one an axis, those of `after_axes`, the metrics,
// simulated_s, and the machine's.
inline constexpr std::size_t kColumnsBeforeAxes = 3;

/// Columns counted from the one after the last axis.
namespace after_axes {
enum Column : std::size_t { kStrength, kStage, kSeed, kOutcome, kReasons, kImpulse };
inline constexpr std::array<std::string_view, 6> kNames{"strength", "stage",   "seed",
                                                        "outcome",  "reasons", "impulse_Nspkg"};
}  // namespace after_axes

/// A line, and what is read from it again.
struct CellRow {
  CellKey cell;
  std::string id;  ///< Of its ray.
  CellOutcome outcome{CellOutcome::kInvalid};
  std::string reasons;
  double impulse_Nspkg{0.0};
  double cpu_s{0.0};
  std::string line;  ///< Without its end.

  /// The line without the columns of the machine.
  std::string_view Repeatable() const;
};

/// By ray, strength and seed.
using CellName = std::tuple<std::size_t, std::string, std::string>;
using CellRows = std::map<CellName, CellRow>;

CellName NameOf(const CellKey& cell);

/// The first line of a table of `spec`'s cells, without its end.
std::string RowHeader(const SweepSpec& spec);

/// The row of a run.
CellRow MakeRow(const SweepSpec& spec, const Ray& ray, const std::string& id, const CellKey& cell,
                const CellResult& result);

/// Reads a line. @throws ConfigError `place: error: ...` if it is no row of `spec`.
CellRow ReadRow(const SweepSpec& spec, const std::string& line, const std::string& place);

}  // namespace sidestep
