// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// made_map: tables of cells that nobody ran.

#include <string>
#include <vector>

#include "sim/map/sweep_map.h"
#include "sim/sweep/csv_line.h"

namespace sidestep::map {

inline constexpr const char* kHeader =
    "ray,id,controller,pushes.0.direction_rad,pushes.0.at_phase,strength,stage,seed,outcome,"
    "reasons,"
    "impulse_Nspkg,fall\n";

/// Whether `text` has `part` somewhere.
inline bool Has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// A run's row of a table with kHeader.
inline std::string MadeRow(int ray, const std::string& controller, const std::string& direction,
                           const std::string& strength, const std::string& outcome,
                           const std::string& phase = "mid_swing") {
  const std::string reasons = outcome == "LOST" ? "FALL at 3 s: low, very; SLIP" : "";
  return CsvLine({std::to_string(ray), "id", controller, direction, phase, strength, "ladder", "",
                  outcome, reasons, strength, "false"}) +
         "\n";
}

/// A row a strength of 1, 2, 3 N s/kg: survived up to `survived`.
inline std::string MadeRay(int ray, const std::string& controller, const std::string& direction,
                           int survived, const std::string& phase = "mid_swing") {
  std::string rows;
  for (int strength = 1; strength <= 3; ++strength) {
    rows += MadeRow(ray, controller, direction, std::to_string(strength),
                    strength <= survived ? "RECOVERED" : "LOST", phase);
  }
  return rows;
}

/// Two controllers, four directions, one phase: `ours` survives 1, 2, 3, 0; `fixed` 0, 2, 1, 1.
inline SweepMap MadeMap() {
  const std::vector<std::string> directions{"0", "1.5707963267948966", "3.141592653589793",
                                            "4.71238898038469"};
  std::string csv = kHeader;
  int ray = 0;
  for (const auto& [controller, limits] :
       {std::pair<std::string, std::vector<int>>{"ours", {1, 2, 3, 0}}, {"fixed", {0, 2, 1, 1}}}) {
    for (std::size_t i = 0; i < limits.size(); ++i) {
      csv += MadeRay(ray++, controller, directions[i], limits[i]);
    }
  }
  return ParseMap(csv, "made", "cells.csv");
}

}  // namespace sidestep::map
