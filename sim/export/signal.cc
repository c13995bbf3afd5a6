// SPDX-License-Identifier: BSD-3-Clause
#include "sim/export/signal.h"

#include <map>
#include <utility>

#include "sim/export/column_path.h"

namespace sidestep {

std::vector<Signal> SignalsOf(const CsvTable& trajectory) {
  std::vector<Signal> signals;
  std::map<std::vector<std::string>, std::size_t> place;
  for (const std::string& column : trajectory.header()) {
    if (column == "time_s") continue;
    ColumnPath path = PathOf(column);
    const auto [found, is_new] = place.emplace(path.group, signals.size());
    if (is_new) signals.push_back({path.group, {}, {}, {}});
    Signal& signal = signals[found->second];
    signal.elements.push_back(path.element.empty() ? path.group.back() : std::move(path.element));
    signal.units.push_back(std::move(path.unit));
    signal.values.push_back(trajectory.Numbers(column));
  }
  return signals;
}

}  // namespace sidestep
