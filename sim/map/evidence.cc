// SPDX-License-Identifier: BSD-3-Clause
#include "sim/map/evidence.h"

#include <algorithm>

#include "models/support/config_error.h"
#include "sim/process/process.h"
#include "sim/record/run_summary.h"
#include "sim/sweep/keep_run.h"

namespace sidestep::map {
namespace {

namespace fs = std::filesystem;

const MapPoint* SmallestLost(const MapCell& cell) {
  for (const MapPoint& point : cell.points) {  // by rising impulse
    if (point.survival() == Survival::kLost) return &point;
  }
  return nullptr;
}

CellKey KeyOf(const MapPoint& point) {
  return {point.ray, point.strength, point.seed, SearchStage::kSingle};
}

fs::path EvidenceFolder(const CellKey& cell) {
  return fs::path("cells") / KeptRunFolder("", cell).filename();
}

CellOutcome OutcomeOf(const RunSummary& summary) {
  if (summary.verdict == VerdictClass::kInvalid) return CellOutcome::kInvalid;
  const auto recovered = summary.metrics.find("recovered");
  const bool has_recovered = recovered != summary.metrics.end() &&
                             std::holds_alternative<bool>(recovered->second) &&
                             std::get<bool>(recovered->second);
  return has_recovered ? CellOutcome::kRecovered : CellOutcome::kLost;
}

// Into a folder beside, which takes its name once it is whole. A FAIL is what is wanted.
void RunCell(const SweepPlan& plan, const CellKey& cell, const fs::path& program,
             const fs::path& folder) {
  const fs::path part = folder.string() + ".part";
  std::vector<std::string> words{program,   "run", plan.spec.scenario, "--out", part,
                                 "--force", "-q"};
  for (const std::string& one : OverridesOf(plan.spec, plan.rays.at(cell.ray).ray, cell)) {
    words.insert(words.end(), {"--set", one});
  }
  const ProcessResult result = RunProcess(words);
  if (!fs::exists(part / "summary.json")) {
    throw ConfigError(DescribeFailure("sidestep run", result));
  }
  for (const char* bulk : {"trajectory.csv", "states.bin", "mpc.csv"}) fs::remove(part / bulk);
  fs::remove_all(folder);
  fs::rename(part, folder);
}

}  // namespace

std::vector<WorstPoint> WorstPoints(const SweepMap& map, std::size_t most) {
  std::vector<WorstPoint> worst;
  for (std::size_t controller = 0; controller < map.controllers.size(); ++controller) {
    std::vector<WorstPoint> lost;
    for (std::size_t i = 0; i < map.cells.size(); ++i) {
      const MapPoint* point = SmallestLost(map.cells[i]);
      if (map.cells[i].controller == controller && point != nullptr) lost.push_back({i, point});
    }
    std::stable_sort(lost.begin(), lost.end(), [&](const auto& a, const auto& b) {
      return ValueOf(map, map.cells[a.cell]) < ValueOf(map, map.cells[b.cell]);
    });
    lost.resize(std::min(lost.size(), most));
    worst.insert(worst.end(), lost.begin(), lost.end());
  }
  return worst;
}

CellEvidence ReadEvidence(const fs::path& run_dir, CellOutcome expected) {
  CellEvidence evidence;
  const CellOutcome outcome = OutcomeOf(ReadSummary(run_dir));
  if (outcome != expected) {
    evidence.note = "run again it came out " + std::string(EnumName(outcome)) + ", the row says " +
                    std::string(EnumName(expected));
  }
  evidence.has_video = fs::exists(run_dir / "video.mp4");
  for (const char* plot : {"top_view", "com", "contact_forces", "step_adjustment"}) {
    const std::string file = std::string("plots/") + plot + ".svg";
    if (fs::exists(run_dir / file)) evidence.plots.push_back(file);
  }
  return evidence;
}

void AddEvidence(const SweepPlan& plan, const fs::path& folder, const EvidenceOrder& order,
                 const std::function<void(const std::string&)>& note, SweepMap* map) {
  for (const WorstPoint& one : WorstPoints(*map, static_cast<std::size_t>(order.worst))) {
    const CellKey key = KeyOf(*one.point);
    const fs::path place = folder / EvidenceFolder(key);
    try {
      if (!fs::exists(place)) RunCell(plan, key, order.program, place);
    } catch (const ConfigError& error) {
      note("no evidence in " + place.string() + ": " + error.what());
    }
  }
  for (MapCell& cell : map->cells) {
    const MapPoint* point = SmallestLost(cell);
    if (point == nullptr) continue;
    const fs::path name = EvidenceFolder(KeyOf(*point));
    if (!fs::exists(folder / name / "summary.json")) continue;
    cell.evidence = ReadEvidence(folder / name, CellOutcome::kLost);
    cell.evidence->folder = name;
    if (!cell.evidence->note.empty()) note((folder / name).string() + ": " + cell.evidence->note);
  }
}

}  // namespace sidestep::map
