// SPDX-License-Identifier: BSD-3-Clause
#include "sim/map/write_map.h"

#include <algorithm>
#include <set>
#include <vector>

#include "models/support/config_error.h"
#include "sim/map/map_commands.h"
#include "sim/map/map_page.h"
#include "sim/map/map_physics.h"
#include "sim/map/pictures.h"
#include "sim/record/output_file.h"

namespace sidestep {
namespace {

namespace fs = std::filesystem;

// Kept runs, as the page names them.
std::vector<std::string> KeptRuns(const fs::path& folder) {
  std::vector<std::string> kept;
  std::error_code none;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder / "runs", none)) {
    kept.push_back("runs/" + entry.path().filename().string());
  }
  return kept;
}

// Both sides of a PNG stay within what gnuplot and viewers take.
double ScaleOf(const map::Drawing& drawing) {
  constexpr double kScale = 1.5;
  constexpr double kMostPixels = 6000.0;
  return std::min(kScale, kMostPixels / std::max(drawing.width(), drawing.height()));
}

}  // namespace

void WriteMap(const SweepPlan& plan, const fs::path& folder, const map::EvidenceOrder& evidence,
              const std::function<void(const std::string&)>& note) {
  map::SweepMap map = map::ReadMap(folder);
  map.name = plan.spec.name;
  map::AddPhysics(plan, &map);
  map::AddCommands(plan, &map);
  map::AddEvidence(plan, folder, evidence, note, &map);
  const map::Drawing sheet = map::SheetPicture(map);
  WriteWholeFile(folder / "map.html", map::MapPage(map, KeptRuns(folder)));
  WriteWholeFile(folder / "map.svg", map::SvgFile(sheet, map.name + ": pushes survived"));
  try {
    WriteWholeFile(folder / "map.png", map::PngFile(sheet, ScaleOf(sheet)));
  } catch (const ConfigError& error) {
    note(std::string("no map.png: ") + error.what());
  }
}

}  // namespace sidestep
