// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// recorder: writes a run's folder while the run goes on.
//
// In : truth and ControlTick of every control tick, then the outcome.
// Out: scenario.yaml, trajectory.csv, states.bin, mpc.csv as it goes; footsteps.csv and
//      summary.json at the end. run_reader.h and run_summary.h read them back.
// LogDetail tells how many rows trajectory.csv keeps and to which digit, or that neither it nor
// states.bin is written. A run that is cut short leaves whole rows; summary.json appears complete
// or not at all.

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "controller/types/control_tick.h"
#include "controller/types/tick.h"
#include "sim/record/log_detail.h"
#include "sim/record/tick_times.h"
#include "sim/scenario/scenario.h"
#include "sim/verdict/verdict.h"
#include "sim/world/world.h"

namespace sidestep {

class Recorder {
 public:
  /// Creates `run_dir` if need be and opens its files, over older ones; removes an older summary.
  /// @param command  The program's arguments, for the summary. @param detail  What is kept of
  /// ticks.
  /// @throws ConfigError if a file can't be written, here and in every other member.
  Recorder(const Scenario& scenario, const World& world, const std::filesystem::path& run_dir,
           std::vector<std::string> command, LogDetail detail = LogDetail::kFull);
  ~Recorder();

  /// A second recorder that stands where this one does: its folder holds every row that was added
  /// so far, and both go on, each for itself. A fork that is given the same ticks and outcome as
  /// this recorder leaves the same files. Creates `run_dir` as the constructor does.
  /// Precondition: Finish was not called.
  /// @throws ConfigError if `run_dir` is this recorder's own folder.
  std::unique_ptr<Recorder> ForkTo(const std::filesystem::path& run_dir) const;

  /// Adds the row of a control tick.
  /// @param truth  State at `tick`, before the command acts.
  void Add(Tick tick, const WorldTruth& truth, const ControlTick& control, const TickTimes& times);

  /// Closes the streams, then writes footsteps.csv and summary.json. Call once.
  /// @param simulated_s  Time the run covered. @param took  Time it took.
  void Finish(const RunOutcome& outcome, double simulated_s, const RunTime& took);

 private:
  struct State;
  explicit Recorder(std::unique_ptr<State> state);

  std::unique_ptr<State> state_;
};

}  // namespace sidestep
