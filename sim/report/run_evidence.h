// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// run_evidence: what a report shows of one run, as plain data.

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

namespace sidestep::report {

struct RunEvidence {
  std::filesystem::path dir;
  std::string name;
  std::string verdict;
  std::string description;
  nlohmann::json summary;
  std::string scenario_yaml;
  std::vector<std::pair<std::string, std::string>> settings;  ///< Dotted key, value as written.
  std::string video;                                          ///< Bytes of video.mp4; may be empty.
  std::vector<std::pair<std::string, std::string>> plots;     ///< Name and SVG file's text.
};

/// Reads a run's folder. @throws ConfigError if summary.json or scenario.yaml can't be read.
RunEvidence LoadEvidence(const std::filesystem::path& run_dir);

/// A JSON value for people: 6 significant digits, yes or no, a dash for null or absent.
std::string Readable(const nlohmann::json& value);

/// object[key], or null if it is absent or `object` is no object.
nlohmann::json Get(const nlohmann::json& object, const std::string& key);

/// As Get, but an empty list if it is no list.
nlohmann::json GetList(const nlohmann::json& object, const std::string& key);

}  // namespace sidestep::report
