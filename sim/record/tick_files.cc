// SPDX-License-Identifier: BSD-3-Clause
#include "sim/record/tick_files.h"

#include <vector>

#include "controller/types/tick.h"
#include "models/support/require.h"
#include "sim/record/states_row.h"

namespace sidestep {
namespace {

constexpr const char* kTrajectory = TickFiles::kNames[0];
constexpr const char* kStates = TickFiles::kNames[1];

std::string StatesHeaderOf(const Scenario& scenario, const World& world) {
  std::vector<std::string> feet;
  for (const FootDescription& foot : scenario.robot.feet) feet.push_back(foot.name);
  const double tick_s = scenario.world.step_s;
  const double dt_s = SecondsAt(TickAt(1.0 / scenario.control.rate_hz, tick_s), tick_s);
  return StatesHeader(feet, static_cast<int>(world.truth().qpos.size()), dt_s);
}

}  // namespace

TickFiles::TickFiles(const Scenario& scenario, const World& world,
                     const std::filesystem::path& run_dir, LogDetail detail)
    : table_(scenario.robot, scenario.plant, scenario.control.mode, world.joints(), detail),
      trajectory_(run_dir / kTrajectory),
      states_(run_dir / kStates),
      skips_rows_(detail == LogDetail::kNormal) {
  SIDESTEP_REQUIRE(detail != LogDetail::kNone, EnumName(detail));
  trajectory_.Append(table_.Header());
  states_.Append(StatesHeaderOf(scenario, world));
}

TickFiles::TickFiles(const TickFiles& start, const std::filesystem::path& run_dir)
    : table_(start.table_),
      trajectory_(run_dir / kTrajectory, start.trajectory_),
      states_(run_dir / kStates, start.states_),
      skips_rows_(start.skips_rows_),
      skipped_(start.skipped_),
      is_skipping_(start.is_skipping_) {}

void TickFiles::Add(const TrajectoryRow& row) {
  row_.clear();
  table_.AppendRow(row, row_);
  if (is_skipping_) {
    skipped_.swap(row_);
  } else {
    trajectory_.Append(row_);
    skipped_.clear();
  }
  is_skipping_ = skips_rows_ && !is_skipping_;

  row_.clear();
  AppendStatesRow(row.time_s, row.truth, row.control, row_);
  states_.Append(row_);
}

void TickFiles::Flush() {
  trajectory_.Flush();
  states_.Flush();
}

void TickFiles::Close() {
  trajectory_.Append(skipped_);
  trajectory_.Close();
  states_.Close();
}

}  // namespace sidestep
