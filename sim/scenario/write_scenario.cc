// SPDX-License-Identifier: BSD-3-Clause
#include "sim/scenario/write_scenario.h"

#include <algorithm>

#include "sim/scenario/yaml_writer.h"

namespace sidestep {
namespace {

std::string RobotReference(const Scenario& scenario) {
  const std::vector<std::string> shipped = ShippedRobots();
  const bool is_shipped =
      std::find(shipped.begin(), shipped.end(), scenario.robot_name) != shipped.end();
  return is_shipped ? scenario.robot_name : scenario.robot.file.string();
}

void WriteBasics(const Scenario& scenario, YamlWriter* yaml) {
  ScenarioBasics basics = scenario;
  basics.robot_name = RobotReference(scenario);
  yaml->Fields(basics);
}

void WriteExpectations(const char* key, const std::vector<Expectation>& expectations,
                       YamlWriter* yaml) {
  if (expectations.empty()) {
    yaml->Line(key, "{}");
    return;
  }
  yaml->Begin(key);
  for (const Expectation& expectation : expectations) {
    if (expectation.is) {
      yaml->Line(expectation.metric, *expectation.is ? "true" : "false");
      continue;
    }
    std::string interval;
    if (expectation.min) interval = "min: " + YamlNumber(*expectation.min);
    if (expectation.min && expectation.max) interval += ", ";
    if (expectation.max) interval += "max: " + YamlNumber(*expectation.max);
    yaml->Line(expectation.metric, "{" + interval + "}");
  }
  yaml->End();
}

/// The sections: structs as they are, and what files spell in a form of its own.
struct SectionWriter {
  YamlWriter* yaml;

  template <typename T>
  void operator()(const char* key, const T& section, Meaning meaning) {
    (*yaml)(key, section, meaning);
  }

  void operator()(const char* key, const std::vector<GaitParams>& gaits, Meaning /*meaning*/) {
    yaml->List(key, gaits);
  }

  void operator()(const char* key, const std::vector<Push>& pushes, Meaning /*meaning*/) {
    std::vector<PushEntry> entries;
    for (const Push& push : pushes) {
      PushEntry& entry = entries.emplace_back();
      entry.push = push;
      entry.force_N = push.force_N;
      entry.start_s = push.start_s;
    }
    yaml->List(key, entries);
  }

  void operator()(const char* key, const std::vector<Expectation>& expectations,
                  Meaning /*meaning*/) {
    WriteExpectations(key, expectations, yaml);
  }

  void operator()(const char* key, const VideoParams& video, Meaning meaning) {
    if (video.enabled) {
      (*yaml)(key, video, meaning);
    } else {
      yaml->Line(key, "false");
    }
  }
};

}  // namespace

std::string ResolvedYaml(const Scenario& scenario) {
  YamlWriter yaml;
  WriteBasics(scenario, &yaml);
  Scenario::VisitSections(scenario, SectionWriter{&yaml});
  return yaml.text();
}

}  // namespace sidestep
