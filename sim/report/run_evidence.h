// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// run_evidence: what a report shows of one run, as plain data.

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "sim/record/run_summary.h"

namespace sidestep::report {

struct RunEvidence {
  std::filesystem::path dir;
  std::string description;  ///< The scenario's.
  RunSummary summary;
  std::string scenario_yaml;
  std::vector<std::pair<std::string, std::string>> settings;  ///< Dotted key, value as written.
  std::string video;                                          ///< Bytes of video.mp4; may be empty.
  std::vector<std::pair<std::string, std::string>> plots;     ///< Name and SVG file's text.
};

/// Reads a run's folder. @throws ConfigError if summary.json or scenario.yaml can't be read.
RunEvidence LoadEvidence(const std::filesystem::path& run_dir);

/// A value for people: 6 significant digits, a dash for what was not measured.
std::string Readable(double value);
/// "yes" or "no".
std::string Readable(bool value);
std::string Readable(const MetricValue& value);

}  // namespace sidestep::report
