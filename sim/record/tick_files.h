// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// tick_files: the two files of a run's folder that have a row a control tick, trajectory.csv and
// states.bin, while they grow.

#include <array>
#include <filesystem>
#include <string>

#include "sim/record/log_detail.h"
#include "sim/record/output_file.h"
#include "sim/record/trajectory_table.h"
#include "sim/scenario/scenario.h"
#include "sim/world/world.h"

namespace sidestep {

/// states.bin takes every tick. So does a trajectory.csv of full detail; one of normal detail takes
/// the first, every second from there on, and the last. Members throw ConfigError if a file can't
/// be written.
class TickFiles {
 public:
  static constexpr std::array<const char*, 2> kNames{"trajectory.csv", "states.bin"};

  /// Creates both files in `run_dir`, over older ones. Precondition: `detail` is not kNone.
  TickFiles(const Scenario& scenario, const World& world, const std::filesystem::path& run_dir,
            LogDetail detail);

  /// Creates both in another folder with all that `start` was given; both go on for themselves.
  TickFiles(const TickFiles& start, const std::filesystem::path& run_dir);

  /// Adds a tick.
  void Add(const TrajectoryRow& row);

  /// Puts what was added on disk, but for a row that may yet be left out.
  void Flush();

  /// As Flush, with the last row; nothing may be added afterwards.
  void Close();

 private:
  TrajectoryTable table_;
  OutputFile trajectory_;
  OutputFile states_;
  bool skips_rows_;
  std::string skipped_;  ///< The last tick's row, if it is left out unless it stays the last.
  bool is_skipping_{false};
  std::string row_;  ///< Kept for its memory.
};

}  // namespace sidestep
