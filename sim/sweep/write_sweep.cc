// SPDX-License-Identifier: BSD-3-Clause
#include "models/support/config_tree.h"
#include "sim/scenario/yaml_writer.h"
#include "sim/sweep/read_sweep.h"

namespace sidestep {
namespace {

std::string AssignmentsYaml(const std::vector<std::string>& assignments) {
  std::string text;
  for (const std::string& assignment : assignments) {
    const std::size_t equals = assignment.find('=');
    const std::string value = assignment.substr(equals + 1);
    text += (text.empty() ? "" : ", ") + YamlScalar(assignment.substr(0, equals)) + ": " +
            FlowText(ParseConfig(value, ConfigSource{assignment, false}));
  }
  return "{" + text + "}";
}

}  // namespace

std::string SweepYaml(const SweepSpec& spec) {
  std::string text = "sidestep_sweep: 1\nname: " + YamlScalar(spec.name) +
                     "\nscenario: " + YamlScalar(spec.scenario.string()) + "\n";
  if (!spec.set.empty()) text += "set: " + AssignmentsYaml(spec.set) + "\n";
  if (!spec.axes.empty()) text += "vary:\n";
  for (const Axis& axis : spec.axes) {
    const bool is_list = axis.text.starts_with('[');
    text +=
        "  " + YamlScalar(axis.key) + ": " + (is_list ? axis.text : YamlScalar(axis.text)) + "\n";
  }
  if (spec.limit) {
    std::string ladder;
    for (const double strength : spec.limit->ladder) {
      ladder += (ladder.empty() ? "" : ", ") + YamlNumber(strength);
    }
    text += "limit: {key: " + YamlScalar(spec.limit->key) + ", ladder: [" + ladder +
            "], resolution: " + YamlNumber(spec.limit->resolution) + "}\n";
  }
  text += "controllers:\n";
  for (const ControllerSpec& one : spec.controllers) {
    text += "  " + YamlScalar(one.name) + ": " + AssignmentsYaml(one.set) + "\n";
  }
  if (!spec.seeds.empty()) {
    std::string seeds;
    for (const std::uint64_t seed : spec.seeds) {
      seeds += (seeds.empty() ? "" : ", ") + std::to_string(seed);
    }
    text += "seeds: [" + seeds + "]\n";
  }
  return text + "sample_seed: " + std::to_string(spec.sample_seed) + "\n";
}

}  // namespace sidestep
