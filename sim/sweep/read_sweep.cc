// SPDX-License-Identifier: BSD-3-Clause
#include "sim/sweep/read_sweep.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <set>
#include <utility>

#include "models/support/config_error.h"
#include "models/support/config_node.h"
#include "models/support/plain_word.h"
#include "sim/scenario/find_scenario.h"
#include "sim/sweep/rays.h"

namespace sidestep {
namespace {

constexpr std::int64_t kFormatVersion = 1;
constexpr std::int64_t kMostSeeds = 100'000;
constexpr double kMostRays = 1e6;    // each is kept in memory, and is a run at the least
constexpr double kGapShare = 0.125;  // of the ladder's smallest gap: three halvings

ConfigPlace OptionPlace(const std::string& option) {
  return {std::make_shared<const ConfigSource>(ConfigSource{option, false}), 1, 1};
}

ConfigTree ParseOption(const std::string& option, const std::string& value) {
  return ParseConfig(value, ConfigSource{option + " " + value, false});
}

// A map of dotted keys as assignments.
std::vector<std::string> ReadAssignments(const ConfigTree& map, const std::string& path) {
  std::vector<std::string> assignments;
  if (map.kind == ConfigKind::kNull) return assignments;
  if (map.kind != ConfigKind::kMap) FailAt(map.place, path + " must be a map of a scenario's keys");
  for (std::size_t i = 0; i < map.keys.size(); ++i) {
    CheckKey(map.keys[i].text, map.keys[i].place);
    assignments.push_back(map.keys[i].text + "=" + FlowText(map.children[i]));
  }
  return assignments;
}

std::vector<ControllerSpec> ReadControllers(const ConfigTree& map) {
  if (map.kind != ConfigKind::kMap || map.keys.empty()) {
    FailAt(map.place, "controllers must be a map from names to overrides");
  }
  std::vector<ControllerSpec> controllers;
  for (std::size_t i = 0; i < map.keys.size(); ++i) {
    const std::string& name = map.keys[i].text;
    if (!IsPlainWord(name)) {
      FailAt(map.keys[i].place, "name '" + name + "' must be " + std::string(kPlainWordRule));
    }
    controllers.push_back({name, ReadAssignments(map.children[i], "controllers." + name)});
  }
  return controllers;
}

std::vector<std::uint64_t> ReadSeeds(const ConfigNode& node) {
  constexpr std::int64_t kMax = std::numeric_limits<std::int64_t>::max();
  std::vector<std::uint64_t> seeds;
  if (node.tree().kind == ConfigKind::kList) {
    std::set<std::uint64_t> seen;
    for (const ConfigNode& seed : node.List()) {
      seeds.push_back(static_cast<std::uint64_t>(seed.Integer(0, kMax)));
      if (!seen.insert(seeds.back()).second) seed.Fail("= " + seed.Text() + " is there twice");
    }
    if (seeds.empty()) node.Fail("is empty");
    return seeds;
  }
  const std::int64_t count = node.Integer(1, kMostSeeds);
  for (std::int64_t seed = 1; seed <= count; ++seed) {
    seeds.push_back(static_cast<std::uint64_t>(seed));
  }
  return seeds;
}

LimitSpec LimitOf(const Axis& axis, const ConfigPlace& place) {
  LimitSpec limit;
  limit.key = axis.key;
  if (axis.kind != AxisKind::kGrid) FailAt(place, axis.key + ": a ladder is not drawn by chance");
  for (const std::string& value : axis.values) {
    const std::optional<double> strength = ParseNumber(value);
    const bool is_good =
        strength && *strength > 0.0 && (limit.ladder.empty() || *strength > limit.ladder.back());
    if (!is_good) FailAt(place, axis.key + ": a ladder is of rising numbers above 0");
    limit.ladder.push_back(*strength);
  }
  double gap = limit.ladder.front();
  for (std::size_t i = 1; i < limit.ladder.size(); ++i) {
    gap = std::min(gap, limit.ladder[i] - limit.ladder[i - 1]);
  }
  limit.resolution = kGapShare * gap;
  return limit;
}

void AddAxis(Axis axis, const ConfigPlace& place, SweepSpec* spec) {
  for (const Axis& other : spec->axes) {
    if (other.key == axis.key) FailAt(place, axis.key + " is varied twice");
    const bool is_drawn = axis.kind != AxisKind::kGrid && other.kind == axis.kind;
    if (is_drawn && other.count != axis.count) {
      FailAt(place, axis.key + " = " + axis.text + " must have as many values as " + other.key +
                        ", " + std::to_string(other.count) + ": they are drawn together");
    }
  }
  spec->axes.push_back(std::move(axis));
}

// The limit's ladder is the axis that varies its key.
void TakeLadder(const std::string& key, const ConfigPlace& place, SweepSpec* spec) {
  const auto found = std::find_if(spec->axes.begin(), spec->axes.end(),
                                  [&](const Axis& axis) { return axis.key == key; });
  if (found == spec->axes.end()) {
    CheckKey(key, place);
    FailAt(place, "the limit " + key + " has no ladder: vary it too, or write it after the key");
  }
  spec->limit = LimitOf(*found, place);
  spec->axes.erase(found);
}

void ReadLimit(const ConfigNode& node, SweepSpec* spec) {
  if (node.tree().kind == ConfigKind::kScalar) {
    TakeLadder(node.Text(), node.tree().place, spec);
    return;
  }
  ConfigMap map = node.Map();
  const std::string key = map.Required("key").Text();
  if (const auto ladder = map.Optional("ladder")) {
    spec->limit = LimitOf(ReadAxis(key, ladder->tree()), ladder->tree().place);
  } else {
    TakeLadder(key, node.tree().place, spec);
  }
  if (const auto resolution = map.Optional("resolution")) {
    spec->limit->resolution = resolution->Number(std::numeric_limits<double>::min(), 1e12);
  }
  map.RejectUnknownKeys();
}

std::filesystem::path AbsoluteScenario(const std::string& word,
                                       const std::filesystem::path& folder) {
  const std::filesystem::path beside = folder / word;
  const bool is_beside = std::filesystem::is_regular_file(beside);
  return std::filesystem::absolute(is_beside ? beside : FindScenario(word)).lexically_normal();
}

void ReadVersion(ConfigMap* map) {
  const ConfigNode version = map->Required(kSweepKey);
  if (version.Integer(0, std::numeric_limits<std::int32_t>::max()) != kFormatVersion) {
    version.Fail("= " + version.Text() + " is a format that this program can't read; it reads 1");
  }
}

void ReadScenarioName(const std::filesystem::path& file, ConfigMap* map, SweepSpec* spec) {
  const ConfigNode scenario = map->Required("scenario");
  try {
    spec->scenario = AbsoluteScenario(scenario.Text(), file.parent_path());
  } catch (const ConfigError&) {
    scenario.Fail("= '" + scenario.Text() +
                  "' is no scenario, neither beside this file nor one that ships");
  }
}

void ReadAxes(const ConfigNode& node, SweepSpec* spec) {
  const ConfigTree& axes = node.tree();
  if (axes.kind != ConfigKind::kMap) node.Fail("must be a map from keys to their values");
  Mistakes mistakes;
  for (std::size_t i = 0; i < axes.keys.size(); ++i) {
    const ConfigKey& key = axes.keys[i];
    mistakes.Try([&] {
      CheckKey(key.text, key.place);
      AddAxis(ReadAxis(key.text, axes.children[i]), key.place, spec);
    });
  }
  mistakes.Throw();
}

SweepSpec ReadSweepFile(const std::filesystem::path& file, const ConfigTree& root) {
  ConfigMap map(root, "");
  SweepSpec spec;
  ReadVersion(&map);
  Mistakes mistakes;
  mistakes.Try([&] { spec.name = map.Required("name").Word(); });
  mistakes.Try([&] { ReadScenarioName(file, &map, &spec); });
  const auto read = [&](const char* key, const auto& reader) {
    if (const auto node = map.Optional(key)) mistakes.Try([&] { reader(*node); });
  };
  read("set", [&](const ConfigNode& node) { spec.set = ReadAssignments(node.tree(), "set"); });
  read("vary", [&](const ConfigNode& node) { ReadAxes(node, &spec); });
  read("limit", [&](const ConfigNode& node) { ReadLimit(node, &spec); });
  read("controllers",
       [&](const ConfigNode& node) { spec.controllers = ReadControllers(node.tree()); });
  read("seeds", [&](const ConfigNode& node) { spec.seeds = ReadSeeds(node); });
  read("sample_seed", [&](const ConfigNode& node) {
    spec.sample_seed =
        static_cast<std::uint64_t>(node.Integer(0, std::numeric_limits<std::int64_t>::max()));
  });
  mistakes.Try([&] { map.RejectUnknownKeys(); });
  mistakes.Throw();
  return spec;
}

void AddLimitOption(const std::string& limit, SweepSpec* spec) {
  if (limit.find('=') == std::string::npos) {
    TakeLadder(limit, OptionPlace("--limit " + limit), spec);
  } else {
    spec->limit = LimitOf(ParseAxis("--limit", limit), OptionPlace("--limit " + limit));
  }
}

void AddOptions(const SweepOptions& options, SweepSpec* spec) {
  for (const std::string& assignment : options.set) {
    const ConfigPlace place = OptionPlace("--set " + assignment);
    if (assignment.find('=') == std::string::npos) FailAt(place, "must read key=value");
    spec->set.push_back(assignment);
  }
  for (const std::string& vary : options.vary) {
    AddAxis(ParseAxis("--vary", vary), OptionPlace("--vary " + vary), spec);
  }
  if (!options.limit.empty()) AddLimitOption(options.limit, spec);
  if (options.resolution != 0.0) {  // of NaN too
    if (!(options.resolution > 0.0)) {
      throw ConfigError("--resolution: error: must be a number above 0");
    }
    if (!spec->limit)
      throw ConfigError("--resolution: error: goes with a limit, and there is none");
    spec->limit->resolution = options.resolution;
  }
  for (const std::string& controller : options.controllers) {
    for (ControllerSpec& one : ReadControllers(ParseOption("--controller", controller))) {
      spec->controllers.push_back(std::move(one));
    }
  }
  if (!options.seeds.empty()) {
    const ConfigTree seeds = ParseOption("--seeds", options.seeds);
    spec->seeds = ReadSeeds(ConfigNode(seeds, "seeds"));
  }
}

bool IsVaried(const SweepSpec& spec, const std::string& key) {
  return (spec.limit && spec.limit->key == key) ||
         std::any_of(spec.axes.begin(), spec.axes.end(),
                     [&](const Axis& axis) { return axis.key == key; });
}

// An axis would win over what a controller sets, and seeds over an axis, without a word.
void CheckNothingIsToldTwice(const SweepSpec& spec) {
  for (const ControllerSpec& one : spec.controllers) {
    for (const std::string& assignment : one.set) {
      const std::string key = assignment.substr(0, assignment.find('='));
      if (!IsVaried(spec, key)) continue;
      throw ConfigError("controllers: error: '" + one.name + "' sets " + key + ", which is varied");
    }
  }
  if (!spec.seeds.empty() && IsVaried(spec, "seed")) {
    throw ConfigError("seeds: error: seed is varied too");
  }
}

// What only the whole of it can tell.
void CheckWhole(const SweepSpec& spec) {
  CheckNothingIsToldTwice(spec);
  for (const ControllerSpec& one : spec.controllers) {
    const auto twice =
        std::count_if(spec.controllers.begin(), spec.controllers.end(),
                      [&](const ControllerSpec& other) { return other.name == one.name; });
    if (twice > 1) throw ConfigError("controllers: error: '" + one.name + "' is there twice");
  }
  if (!(NumRays(spec) <= kMostRays)) {
    throw ConfigError("vary: error: makes " + NumberText(NumRays(spec)) +
                      " combinations with the controllers, more than " + NumberText(kMostRays));
  }
  if (spec.limit) {
    for (const Axis& axis : spec.axes) {
      if (axis.key == spec.limit->key) {
        throw ConfigError("limit: error: " + axis.key + " is varied too and has a ladder already");
      }
    }
  }
}

}  // namespace

SweepSpec ReadSweep(const std::filesystem::path& target, const SweepOptions& options) {
  const std::filesystem::path file = FindScenario(target);
  const ConfigTree root = ReadConfigFile(file);
  SweepSpec spec;
  if (root.Find(kSweepKey) != nullptr) {
    spec = ReadSweepFile(file, root);
  } else {
    spec.name = file.stem().string();
    spec.scenario = std::filesystem::absolute(file).lexically_normal();
  }
  AddOptions(options, &spec);
  if (spec.controllers.empty()) spec.controllers.push_back({"default", {}});
  CheckWhole(spec);
  return spec;
}

}  // namespace sidestep
