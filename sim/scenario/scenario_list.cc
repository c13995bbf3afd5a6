// SPDX-License-Identifier: BSD-3-Clause
#include "sim/scenario/scenario_list.h"

#include <algorithm>
#include <cstddef>
#include <nlohmann/json.hpp>

#include "models/support/config_node.h"
#include "sim/scenario/find_scenario.h"
#include "sim/scenario/read_scenario.h"

namespace sidestep {

std::string ScenariosText() {
  struct Row {
    std::string name, robot, duration, description;
  };
  std::vector<Row> rows{{"SCENARIO", "ROBOT", "S", "DESCRIPTION"}};
  std::size_t name_width = 0, robot_width = 0, duration_width = 0;
  for (const std::string& name : ShippedScenarios()) {
    const ScenarioBasics basics = ReadScenarioBasics(FindShippedScenario(name));
    rows.push_back({name, basics.robot_name, NumberText(basics.duration_s), basics.description});
  }
  for (const Row& row : rows) {
    name_width = std::max(name_width, row.name.size());
    robot_width = std::max(robot_width, row.robot.size());
    duration_width = std::max(duration_width, row.duration.size());
  }
  std::string text;
  for (const Row& row : rows) {
    text += row.name + std::string(name_width - row.name.size() + 2, ' ');
    text += row.robot + std::string(robot_width - row.robot.size() + 2, ' ');
    text += std::string(duration_width - row.duration.size(), ' ') + row.duration;
    text += (row.description.empty() ? "" : "  " + row.description) + "\n";
  }
  return text;
}

std::string ScenariosJson() {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const std::string& name : ShippedScenarios()) {
    const std::filesystem::path file = FindShippedScenario(name);
    const ScenarioBasics basics = ReadScenarioBasics(file);
    list.push_back({{"name", name},
                    {"robot", basics.robot_name},
                    {"duration_s", basics.duration_s},
                    {"description", basics.description},
                    {"file", file.string()}});
  }
  return list.dump(2) + "\n";
}

}  // namespace sidestep
