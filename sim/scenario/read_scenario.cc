// SPDX-License-Identifier: BSD-3-Clause
#include "sim/scenario/read_scenario.h"

#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>

#include "models/support/config_error.h"
#include "models/support/config_node.h"
#include "models/support/nearest_name.h"
#include "sim/scenario/apply_override.h"
#include "sim/scenario/check_parts.h"
#include "sim/scenario/check_scenario.h"
#include "sim/scenario/find_scenario.h"
#include "sim/scenario/read_fields.h"
#include "sim/scenario/read_sections.h"
#include "sim/scenario/resolve_pushes.h"

namespace sidestep {
namespace {

constexpr std::int64_t kFormatVersion = 1;

void RejectSweep(const ConfigTree& root) {
  if (root.Find(kSweepKey) == nullptr) return;
  FailAt(root.place, "is a sweep's file, no scenario's; sidestep sweep runs it");
}

void ReadVersion(ConfigMap& map) {
  const ConfigNode version = map.Required("sidestep");
  if (version.Integer(0, std::numeric_limits<std::int32_t>::max()) != kFormatVersion) {
    version.Fail("= " + version.Text() + " is a format that this program can't read; it reads 1");
  }
}

// Gains belong to a robot: the `control` block of its robot.yaml stands before the scenario's, and
// `control_torque` between them where the robot is driven by torques. `scenario`: its control, or
// nothing.
void ReadRobotControl(const std::filesystem::path& robot_file,
                      const std::optional<ConfigNode>& scenario, const NoteSink& note,
                      ControlParams* control) {
  ConfigTree root = ReadConfigFile(robot_file);
  RenameOldKeys(&root, note);
  ConfigMap map(root, "");
  if (const auto defaults = map.Optional("control")) ReadFields(*defaults, *control);
  ControlParams asked;
  asked.mode = control->mode;
  if (scenario) ReadFields(*scenario, asked);
  ControlParams on_torques = *control;  // read in any mode: a mistake in it is one
  if (const auto defaults = map.Optional("control_torque")) ReadFields(*defaults, on_torques);
  if (asked.mode == ControlMode::kTorque) *control = on_torques;
}

void ReadRobot(const ConfigNode& node, const std::optional<ConfigNode>& control,
               const NoteSink& note, const RobotReader& read_robot, Scenario* scenario) {
  const bool is_from_file = node.tree().place.source->is_file;
  const std::filesystem::path folder = is_from_file ? scenario->file.parent_path() : "";
  const std::filesystem::path robot_file = FindRobot(scenario->robot_name, folder);
  if (robot_file.empty()) {
    node.Fail("= '" + scenario->robot_name + "' is neither a robot that ships nor a robot.yaml; " +
              DidYouMean(scenario->robot_name, ShippedRobots(), "robots that ship"));
  }
  scenario->robot = read_robot(robot_file);
  ReadRobotControl(robot_file, control, note, &scenario->control);
  // The centroidal plant has no joints: a robot's servos must not stand in a scenario's way there.
  ControlMode& mode = scenario->control.mode;
  const bool has_joints = scenario->plant != Plant::kCentroidal;
  if (mode == ControlMode::kPosition && !has_joints) mode = ControlParams().mode;
}

void ReadBasics(ConfigMap& map, Scenario* scenario) {
  ScenarioBasics::VisitFields(*scenario, FieldReader(&map));
  map.Required("name").Word();  // it becomes a folder's
}

/// Reads the sections: structs as they are, and what files spell in a form of its own.
class SectionReader {
 public:
  SectionReader(ConfigMap* map, const RobotDescription* robot, std::vector<PushEntry>* pushes)
      : map_(map), robot_(robot), pushes_(pushes) {}

  template <typename T>
  void operator()(const char* key, T& section, Meaning /*meaning*/) {
    if (const auto node = map_->Optional(key)) ReadFields(*node, section);
  }
  void operator()(const char* key, std::vector<GaitParams>& gaits, Meaning /*meaning*/) {
    gaits = ReadGaits(map_->Optional(key), *robot_);
  }
  void operator()(const char* key, std::vector<Push>& /*pushes*/, Meaning /*meaning*/) {
    if (const auto node = map_->Optional(key)) *pushes_ = ReadPushes(*node);
  }
  void operator()(const char* key, std::vector<Expectation>& expect, Meaning /*meaning*/) {
    if (const auto node = map_->Optional(key)) expect = ReadExpectations(*node);
  }
  void operator()(const char* key, VideoParams& video, Meaning /*meaning*/) {
    if (const auto node = map_->Optional(key)) video = ReadVideo(*node);
  }

 private:
  ConfigMap* map_;
  const RobotDescription* robot_;
  std::vector<PushEntry>* pushes_;  ///< What they come to, only the whole scenario tells.
};

/// `file` is empty of a scenario that has none.
Scenario ReadTree(ConfigTree root, const std::filesystem::path& file,
                  const std::vector<std::string>& overrides, const NoteSink& note,
                  const RobotReader& read_robot) {
  ConfigMap map(root, "");
  RenameOldKeys(&root, note);
  for (const std::string& assignment : overrides) ApplyOverride(assignment, &root, note);

  Scenario scenario;
  scenario.file = file;
  RejectSweep(root);
  ReadVersion(map);
  ReadBasics(map, &scenario);
  ReadRobot(map.Required("robot"), map.Optional("control"), note, read_robot, &scenario);
  std::vector<PushEntry> pushes;
  Scenario::VisitSections(scenario, SectionReader(&map, &scenario.robot, &pushes));
  map.RejectUnknownKeys();
  CheckMotion(scenario, root);
  WarnOfServos(scenario, note);
  scenario.pushes = ResolvePushes(pushes, scenario, root);
  CheckSurroundings(scenario, root);
  return scenario;
}

}  // namespace

Scenario ReadScenario(const std::filesystem::path& file, const std::vector<std::string>& overrides,
                      const NoteSink& note, const RobotReader& read_robot) {
  return ReadTree(ReadConfigFile(file), file, overrides, note, read_robot);
}

Scenario ScenarioOfRobot(const std::string& robot, const std::vector<std::string>& overrides,
                         const NoteSink& note) {
  const std::filesystem::path file = FindRobot(robot, "");
  if (file.empty()) {
    throw ConfigError(robot + ": error: is neither a robot that ships nor a robot.yaml; " +
                      DidYouMean(robot, ShippedRobots(), "robots that ship"));
  }
  const RobotDescription description = ReadSoundRobot(file);
  const ConfigSource source{robot, false};
  ConfigTree root =
      ParseConfig(std::string("{sidestep: 1, name: robot, robot: '', duration_s: 1") +
                      ", plant: " + (description.model ? "mujoco" : "centroidal") +
                      ", gait: {type: " + (description.feet.size() == 1 ? "hop" : "walk") + "}}",
                  source);
  root.children[2].scalar = robot;  // as it is: no YAML
  return ReadTree(std::move(root), "", overrides, note, ReadSoundRobot);
}

bool IsRobotFile(const std::filesystem::path& word) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(word, ignored)) return false;
  try {
    return ReadConfigFile(word).Find("sidestep_robot") != nullptr;
  } catch (const ConfigError&) {
    return false;  // as a scenario it will be told what is wrong with it
  }
}

}  // namespace sidestep
