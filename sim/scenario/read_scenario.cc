// SPDX-License-Identifier: BSD-3-Clause
#include "sim/scenario/read_scenario.h"

#include <cstdint>
#include <limits>
#include <string_view>

#include "models/support/config_node.h"
#include "models/support/nearest_name.h"
#include "sim/scenario/apply_override.h"
#include "sim/scenario/check_scenario.h"
#include "sim/scenario/read_fields.h"
#include "sim/scenario/read_sections.h"

namespace sidestep {
namespace {

constexpr std::int64_t kFormatVersion = 1;
constexpr double kMinDuration_s = 0.01;
constexpr double kMaxDuration_s = 1e4;
constexpr std::size_t kMaxNameLength = 100;  // It names a folder; file systems allow 255.

void ReadVersion(ConfigMap& map) {
  const ConfigNode version = map.Required("sidestep");
  if (version.Integer(0, std::numeric_limits<std::int32_t>::max()) != kFormatVersion) {
    version.Fail("= " + version.Text() + " is a format that this program can't read; it reads 1");
  }
}

/// The name becomes a folder's, so it is a plain word.
std::string ReadName(const ConfigNode& node) {
  constexpr std::string_view kAllowed =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-.";
  const std::string name = node.Text();
  const bool is_word = !name.empty() && name.size() <= kMaxNameLength && name[0] != '.' &&
                       name[0] != '-' && name.find_first_not_of(kAllowed) == std::string::npos;
  if (!is_word) {
    node.Fail("= '" + name + "' must be 1 to 100 letters, digits, '_', '-' or '.', and begin " +
              "with neither '-' nor '.'");
  }
  return name;
}

// Gains belong to a robot: the `control` block of its robot.yaml stands before the scenario's.
void ReadRobotControl(const std::filesystem::path& robot_file, ControlParams* control) {
  const ConfigTree root = ReadConfigFile(robot_file);
  ConfigMap map(root, "");
  if (const auto defaults = map.Optional("control")) ReadFields(*defaults, *control);
}

void ReadRobot(const ConfigNode& node, Scenario* scenario) {
  scenario->robot = node.Text();
  const bool is_from_file = node.tree().place.source->is_file;
  const std::filesystem::path folder = is_from_file ? scenario->file.parent_path() : "";
  const std::filesystem::path robot_file = FindRobot(scenario->robot, folder);
  if (robot_file.empty()) {
    node.Fail("= '" + scenario->robot + "' is neither a robot that ships nor a robot.yaml; " +
              DidYouMean(scenario->robot, ShippedRobots(), "robots that ship"));
  }
  scenario->description_of_robot = ReadRobotDescription(robot_file);
  ReadRobotControl(robot_file, &scenario->control);
}

template <typename T>
void ReadSection(ConfigMap& map, const char* key, T& section) {
  if (const auto node = map.Optional(key)) ReadFields(*node, section);
}

void ReadBasics(ConfigMap& map, Scenario* scenario) {
  scenario->name = ReadName(map.Required("name"));
  if (const auto text = map.Optional("description")) scenario->description = text->Text();
  scenario->duration_s = map.Required("duration_s").Number(kMinDuration_s, kMaxDuration_s);
  if (const auto plant = map.Optional("plant")) scenario->plant = ReadEnum<Plant>(*plant);
  if (const auto seed = map.Optional("seed")) {
    const std::int64_t value = seed->Integer(0, std::numeric_limits<std::int64_t>::max());
    scenario->seed = static_cast<std::uint64_t>(value);
  }
}

}  // namespace

Scenario ReadScenario(const std::filesystem::path& file,
                      const std::vector<std::string>& overrides) {
  ConfigTree root = ReadConfigFile(file);
  ConfigMap map(root, "");
  for (const std::string& assignment : overrides) ApplyOverride(assignment, &root);

  Scenario scenario;
  scenario.file = file;
  ReadVersion(map);
  ReadBasics(map, &scenario);
  ReadRobot(map.Required("robot"), &scenario);
  ReadSection(map, "control", scenario.control);
  ReadSection(map, "world", scenario.world);
  ReadSection(map, "sensors", scenario.sensors);
  ReadSection(map, "verdict", scenario.verdict);

  const std::size_t feet = scenario.description_of_robot.feet.size();
  scenario.gait = ReadGaits(map.Optional("gait"), feet);
  if (const auto pushes = map.Optional("pushes")) scenario.pushes = ReadPushes(*pushes);
  if (const auto expect = map.Optional("expect")) scenario.expect = ReadExpectations(*expect);
  if (const auto video = map.Optional("video")) scenario.video = ReadVideo(*video);
  map.RejectUnknownKeys();
  CheckScenario(scenario, root);
  return scenario;
}

}  // namespace sidestep
