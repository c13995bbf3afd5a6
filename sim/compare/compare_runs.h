// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// compare_runs: what two runs were told that differs, what came of it, and when they parted.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "sim/record/log_detail.h"
#include "sim/record/run_reader.h"

namespace sidestep {

/// A key of scenario.yaml that the runs do not share. Empty: that run has none.
struct SettingDifference {
  std::string key;
  std::string first;
  std::string second;
};

/// A metric of both runs; true counts as 1.
struct MetricPair {
  std::string name;
  double first{0.0};
  double second{0.0};
};

/// Where two trajectories are no longer the same, to the last digit.
struct Divergence {
  std::size_t row{0};  ///< From 0.
  std::string time_s;  ///< As the first has it.
  std::string column;  ///< The first that differs; empty: one of them ends here.
};

struct RunComparison {
  std::string first_verdict;
  std::string second_verdict;
  std::vector<SettingDifference> settings;
  std::vector<MetricPair> metrics;
  bool has_trajectories{false};
  LogDetail first_log{LogDetail::kFull};
  LogDetail second_log{LogDetail::kFull};
  std::optional<Divergence> divergence;  ///< None: they are the same, if their logs are comparable.
  bool has_states{false};
  std::optional<Divergence> states_divergence;  ///< None: they are the same, bit for bit.
};

/// Keys of two YAML texts whose values differ; dotted, numbers for lists.
std::vector<SettingDifference> CompareSettings(const std::string& first, const std::string& second);

/// The first difference of two trajectory.csv, in the columns that both have but for those of a
/// clock on the wall (`wall_`).
std::optional<Divergence> CompareTrajectories(const CsvTable& first, const CsvTable& second);

/// The first row of two states.bin that differs in any bit, and in what: time_s, qpos, push, a
/// foot, or their robots, which have not the same coordinates and feet.
std::optional<Divergence> CompareStates(const StateLog& first, const StateLog& second);

/// Reads two runs' folders. Rows of trajectory.csv are compared only of logs of the same detail.
/// @throws ConfigError if a summary or scenario can't be read.
RunComparison CompareRuns(const std::filesystem::path& first, const std::filesystem::path& second);

/// Where the trajectories part, in words.
std::string DivergenceText(const RunComparison& comparison);

/// Where the states part, in words; empty if not both runs have any.
std::string StatesText(const RunComparison& comparison);

/// For a terminal: verdicts, settings, metrics that differ with their changes, where they part.
std::string RunComparisonText(const RunComparison& comparison);

}  // namespace sidestep
