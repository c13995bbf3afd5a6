// SPDX-License-Identifier: BSD-3-Clause
#include "sim/sweep/sweep_plan.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <utility>

#include "models/mjcf/mjcf.h"
#include "models/support/config_error.h"
#include "models/support/config_node.h"
#include "models/support/hash_text.h"
#include "models/support/parse_number.h"
#include "sim/record/output_file.h"
#include "sim/scenario/read_scenario.h"
#include "sim/scenario/write_scenario.h"
#include "sim/sweep/csv_line.h"
#include "sim/sweep/read_sweep.h"
#include "sim/sweep/robot_memory.h"
#include "sim/sweep/shared_prefix.h"

namespace sidestep {
namespace {

constexpr char kSweepFile[] = "sweep.yaml";
constexpr char kManifestFile[] = "manifest.csv";
constexpr std::size_t kManifestColumns = 5;  // and one an axis

[[noreturn]] void FailAtFile(const std::filesystem::path& file, const std::string& what) {
  throw ConfigError(file.string() + ": error: " + what);
}

std::string FirstLine(const std::string& program_hash) {
  return "# sidestep sweep manifest 1, program " + program_hash;
}

std::string Header(const SweepSpec& spec) {
  std::vector<std::string> names{"ray", "id", "prefix", "start_tick", "controller"};
  for (const Axis& axis : spec.axes) names.push_back(axis.key);
  return CsvLine(names);
}

std::string ManifestText(const SweepPlan& plan, const std::string& program_hash) {
  std::string text = FirstLine(program_hash) + "\n" + Header(plan.spec) + "\n";
  for (const PlannedRay& one : plan.rays) {
    std::vector<std::string> cells{std::to_string(one.ray.index), one.id, one.prefix,
                                   std::to_string(one.start_tick),
                                   plan.spec.controllers[one.ray.controller].name};
    cells.insert(cells.end(), one.ray.values.begin(), one.ray.values.end());
    text += CsvLine(cells) + "\n";
  }
  return text;
}

std::string SearchText(const SweepSpec& spec) {
  std::string text;
  if (spec.limit) {
    text = spec.limit->key + " " + NumberText(spec.limit->resolution);
    for (const double strength : spec.limit->ladder) text += " " + NumberText(strength);
  }
  for (const std::uint64_t seed : spec.seeds) text += " seed " + std::to_string(seed);
  return text;
}

// What the resolved scenario names but does not hold.
std::string RobotText(const RobotDescription& robot) {
  return ReadTextFile(robot.file) + (robot.model ? robot.model->simulated_mjcf : "");
}

// What planning leaves if it is killed, or the disk is full, is nobody's.
bool HoldsOtherThings(const std::filesystem::path& folder) {
  if (!std::filesystem::exists(folder)) return false;
  if (!std::filesystem::is_directory(folder)) FailAtFile(folder, "is no folder");
  if (std::filesystem::exists(folder / kSweepFile)) return false;
  const std::filesystem::directory_iterator entries(folder);
  return std::any_of(begin(entries), end(entries), [](const auto& entry) {
    return entry.path().filename() != std::string(kSweepFile) + ".part";
  });
}

void CheckProgram(const std::filesystem::path& manifest, const std::string& first_line) {
  const std::string wanted = FirstLine(ProgramHash());
  if (first_line == wanted) return;
  if (!first_line.starts_with("# sidestep sweep manifest")) FailAtFile(manifest, "is no manifest");
  FailAtFile(manifest, "was planned by another build of the program: '" + first_line +
                           "', this one is " + ProgramHash() +
                           "; plan the sweep again in another folder");
}

}  // namespace

std::string ProgramHash() {
  static const std::string kHash = HashText(ReadTextFile("/proc/self/exe"));
  return kHash;
}

Scenario ScenarioOf(const SweepSpec& spec, const Ray& ray, const CellKey& cell) {
  static RobotMemory robots;
  return ReadScenario(spec.scenario, OverridesOf(spec, ray, cell), {},
                      [](const std::filesystem::path& file) { return robots.Read(file); });
}

PlannedRay PlanRay(const SweepSpec& spec, const Ray& ray, const std::string& program_hash) {
  const Scenario scenario = ScenarioOf(spec, ray, FirstCell(spec, ray));
  PlannedRay planned;
  planned.ray = ray;
  planned.id = HashText(ResolvedYaml(scenario) + RobotText(scenario.robot) + SearchText(spec) +
                        spec.controllers[ray.controller].name + program_hash);
  planned.prefix = HashText(PrefixText(scenario));
  planned.start_tick = FirstPushTick(scenario);
  return planned;
}

SweepPlan MakePlan(const SweepSpec& spec, const std::function<void(double)>& progress) {
  SweepPlan plan;
  plan.spec = spec;
  const std::vector<Ray> rays = RaysOf(spec);
  for (const Ray& ray : rays) {
    plan.rays.push_back(PlanRay(spec, ray, ProgramHash()));
    progress(static_cast<double>(plan.rays.size()) / static_cast<double>(rays.size()));
  }
  return plan;
}

bool HoldsPlan(const SweepSpec& spec, const std::filesystem::path& folder) {
  const std::filesystem::path manifest = folder / kManifestFile;
  if (!std::filesystem::exists(manifest)) {
    if (HoldsOtherThings(folder))
      FailAtFile(folder, "is not empty and holds no sweep; take another folder");
    return false;
  }
  if (ReadTextFile(folder / kSweepFile) != SweepYaml(spec)) {
    FailAtFile(folder, "holds another sweep (see its sweep.yaml); take another folder");
  }
  std::ifstream in(manifest);
  std::string first_line;
  std::getline(in, first_line);
  CheckProgram(manifest, first_line);
  return true;
}

void WritePlan(const SweepPlan& plan, const std::filesystem::path& folder) {
  if (HoldsPlan(plan.spec, folder)) {
    if (ReadTextFile(folder / kManifestFile) != ManifestText(plan, ProgramHash())) {
      FailAtFile(folder / kManifestFile,
                 "was planned from other scenarios or robots; take another folder");
    }
    return;
  }
  std::filesystem::create_directories(folder);
  WriteWholeFile(folder / kSweepFile, SweepYaml(plan.spec));
  WriteWholeFile(folder / kManifestFile, ManifestText(plan, ProgramHash()));
}

SweepPlan ReadPlan(const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / kManifestFile;
  if (!std::filesystem::exists(file)) FailAtFile(folder, "holds no sweep (no manifest.csv)");
  std::istringstream in(ReadTextFile(file));
  std::string line;
  std::getline(in, line);
  CheckProgram(file, line);
  SweepPlan plan;
  plan.spec = ReadSweep(folder / kSweepFile);
  std::getline(in, line);
  std::vector<Ray> rays = RaysOf(plan.spec);
  bool is_whole = line == Header(plan.spec);
  while (is_whole && std::getline(in, line)) {
    const std::vector<std::string> cells = SplitCsvLine(line);
    is_whole =
        plan.rays.size() < rays.size() && cells.size() == kManifestColumns + plan.spec.axes.size();
    if (!is_whole) break;
    PlannedRay& planned = plan.rays.emplace_back();
    planned.ray = std::move(rays[plan.rays.size() - 1]);
    planned.id = cells[1];
    planned.prefix = cells[2];
    const auto start_tick = ParseAs<Tick>(cells[3]);
    is_whole = start_tick && cells[0] == std::to_string(planned.ray.index);
    planned.start_tick = start_tick.value_or(0);
  }
  if (!is_whole || plan.rays.size() != rays.size()) {
    FailAtFile(file,
               "does not go with sweep.yaml beside it; plan the sweep again in another folder");
  }
  return plan;
}

}  // namespace sidestep
