// SPDX-License-Identifier: BSD-3-Clause
#include "sim/map/map_commands.h"

#include <algorithm>

#include "models/support/config_error.h"
#include "sim/scenario/find_scenario.h"

namespace sidestep::map {
namespace {

// The bare name of a scenario that ships, else its path.
std::string NameOfScenario(const std::filesystem::path& file) {
  const std::string stem = file.stem();
  try {
    std::error_code failure;
    if (std::filesystem::equivalent(FindScenario(stem), file, failure)) return stem;
  } catch (const ConfigError&) {  // none ships under this name
  }
  return file;
}

std::string CommandOf(const SweepPlan& plan, const MapPoint& point) {
  const Ray& ray = plan.rays.at(point.ray).ray;
  return RunCommand(plan.spec, ray, {point.ray, point.strength, point.seed, SearchStage::kSingle});
}

}  // namespace

std::string ShellWord(const std::string& word) {
  const auto is_plain = [](unsigned char letter) {
    return std::isalnum(letter) != 0 ||
           std::string_view("_-./=,:+@").find(static_cast<char>(letter)) != std::string_view::npos;
  };
  if (!word.empty() && std::all_of(word.begin(), word.end(), is_plain)) return word;
  std::string quoted = "'";
  for (const char letter : word) {
    if (letter == '\'') {
      quoted += "'\\''";
    } else {
      quoted += letter;
    }
  }
  return quoted + "'";
}

std::string RunCommand(const SweepSpec& spec, const Ray& ray, const CellKey& cell) {
  std::string command = "sidestep run " + ShellWord(NameOfScenario(spec.scenario));
  for (const std::string& assignment : OverridesOf(spec, ray, cell)) {
    command += " --set " + ShellWord(assignment);
  }
  return command;
}

void AddCommands(const SweepPlan& plan, SweepMap* map) {
  for (MapCell& cell : map->cells) {
    cell.commands.clear();
    const CellLimit limit = LimitOf(cell);
    for (const MapPoint& point : cell.points) {
      const Survival survival = point.survival();
      const bool is_survived =
          survival == Survival::kSurvived && point.impulse_Nspkg == limit.survived;
      const bool is_lost = survival == Survival::kLost && point.impulse_Nspkg == limit.lost;
      if (!is_survived && !is_lost) continue;
      if (!cell.commands.empty() && cell.commands.back().first == (is_lost ? "lost" : "survived")) {
        continue;  // several of one impulse
      }
      cell.commands.emplace_back(is_lost ? "lost" : "survived", CommandOf(plan, point));
    }
    if (cell.commands.empty() && !cell.points.empty()) {
      cell.commands.emplace_back("first", CommandOf(plan, cell.points.front()));
    }
  }
}

}  // namespace sidestep::map
