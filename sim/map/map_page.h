// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// map_page: a map as one self-contained page, without script.

#include <string>
#include <vector>

#include "sim/map/sweep_map.h"

namespace sidestep::map {

/// The page: figures per controller, polar and heat maps, differences, a table of all cells. A cell
/// that is chosen shows what was tested and the commands that repeat it; that is plain links and
/// CSS, and works without a script. Follows the reader's light or dark preference.
/// @param kept  Folders of kept runs, relative to the page, by ray (`runs/ray_3`); may be empty.
std::string MapPage(const SweepMap& map, const std::vector<std::string>& kept);

}  // namespace sidestep::map
