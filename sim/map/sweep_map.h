// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// sweep_map: a finished sweep as a map: what every direction of a push came to, per controller and
// combination of the other axes.
//
// Read from a sweep's cells.csv alone, so that maps of other builds of the program can be drawn and
// compared too. An axis of strengths without a limit counts as a ladder.

#include <cstddef>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/sweep/limit_search.h"

namespace sidestep::map {

inline constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

/// The runs of one strength, over all seeds.
struct MapPoint {
  std::string strength;  ///< Of the limit's key; empty without one.
  double impulse_Nspkg{kUnknown};
  std::string stage;
  int recovered{0};
  int lost{0};
  int invalid{0};
  std::string reasons;  ///< Of the first run that did not recover.
  std::size_t ray{0};
  std::string seed;  ///< Of that run, or else of the first.

  Survival survival() const;
};

/// A run of a cell with its pictures, as the page shows it.
struct CellEvidence {
  std::string folder;              ///< Relative to the page.
  std::vector<std::string> plots;  ///< Files in it.
  bool has_video{false};           ///< video.mp4 is in it.
  std::string note;                ///< Empty unless its verdict is not the row's.
};

/// One direction of one panel under one controller.
struct MapCell {
  std::size_t controller{0};  ///< In SweepMap::controllers.
  std::size_t panel{0};       ///< In SweepMap::panels.
  std::string direction;      ///< As the axis has it; empty without such an axis.
  std::optional<double> direction_rad;
  std::vector<MapPoint> points;     ///< By rising impulse.
  double physical_Nspkg{kUnknown};  ///< What a pendulum survives; map_physics.h fills it.
  std::vector<std::pair<std::string, std::string>> commands;  ///< Of what, and that repeats it.
  std::optional<CellEvidence> evidence;  ///< Of the smallest lost impulse; evidence.h fills it.
};

struct SweepMap {
  std::string name;
  std::vector<std::string> controllers;
  /// `at_phase mid_swing`; one empty name without such axes. First digits only: two may be alike.
  std::vector<std::string> panels;
  std::vector<std::string> panel_keys;  ///< The same with every digit; no two are alike.
  std::vector<MapCell> cells;           ///< In order of panel, controller and direction.
  std::vector<std::string> directions;  ///< As axes have them, in the sweep's order.
  bool has_limits{false};               ///< Some cell has more than one strength.
  double omega_per_s{kUnknown};         ///< Of the robot as a pendulum; map_physics.h fills it.
  std::string physics_note;             ///< What the pendulum is of, or why there is none.
};

/// What is known of a cell's limit, in N s/kg.
struct CellLimit {
  double survived{kUnknown};  ///< Everything tried up to here recovered; 0: nothing. NaN: unknown.
  double lost{kUnknown};      ///< The smallest that was lost; infinite: none.
  double share{kUnknown};     ///< Recovered runs of those that recovered or were lost.
};

/// The limit of a cell; all NaN if all its runs are INVALID or it has none.
CellLimit LimitOf(const MapCell& cell);

/// The figure that a map shows of a cell: its `survived`, or the share of a map without limits.
double ValueOf(const SweepMap& map, const MapCell& cell);

/// The cell of that place, or null.
const MapCell* FindCell(const SweepMap& map, std::size_t controller, std::size_t panel,
                        const std::string& direction);

/// Whether all of a map's cells have a direction, and there is more than one direction.
bool HasDirections(const SweepMap& map);

/// Parses the text of a cells.csv. @param name  Of the map. @param file  For errors.
/// @throws ConfigError if it is none.
SweepMap ParseMap(std::string_view cells_csv, const std::string& name, const std::string& file);

/// Reads `folder`/cells.csv. @throws ConfigError if it is missing or broken.
SweepMap ReadMap(const std::filesystem::path& folder);

/// A key without the push that it is of, and a value's first digits: `direction_rad 1.571`.
std::string ShortSetting(const std::string& key, const std::string& value);

}  // namespace sidestep::map
