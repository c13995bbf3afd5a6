// SPDX-License-Identifier: BSD-3-Clause
#include "sim/scenario/read_scenario.h"

#include <optional>
#include <string_view>
#include <utility>

#include "models/support/config_error.h"
#include "models/support/config_node.h"
#include "models/support/nearest_name.h"
#include "sim/scenario/apply_override.h"
#include "sim/scenario/based_on.h"
#include "sim/scenario/check_parts.h"
#include "sim/scenario/check_scenario.h"
#include "sim/scenario/find_scenario.h"
#include "sim/scenario/read_fields.h"
#include "sim/scenario/read_sections.h"
#include "sim/scenario/resolve_pushes.h"

namespace sidestep {
namespace {

// The file's own is gone by now.
void RejectBaseOfOverride(const ConfigTree& root) {
  const ConfigTree* base = root.Find(BasedOn::kKey);
  if (base != nullptr)
    FailAt(base->place, "based_on can't be overridden; write a file that has it");
}

// The mode that a scenario's control asks for. A mistake in it is told where the section is read.
ControlMode AskedMode(const ConfigNode& control, ControlMode otherwise) {
  ControlMode mode = otherwise;
  Mistakes().Try([&] {
    if (const auto asked = control.Map().Optional("mode")) mode = ReadEnum<ControlMode>(*asked);
  });
  return mode;
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
  const ControlMode mode = scenario ? AskedMode(*scenario, control->mode) : control->mode;
  ControlParams on_torques = *control;  // read in any mode: a mistake in it is one
  if (const auto defaults = map.Optional("control_torque")) ReadFields(*defaults, on_torques);
  if (mode == ControlMode::kTorque) *control = on_torques;
}

void ReadRobot(const ConfigNode& node, const std::optional<ConfigNode>& control,
               const NoteSink& note, const RobotReader& read_robot, Scenario* scenario) {
  const ConfigSource& source = *node.tree().place.source;
  const std::filesystem::path folder =
      source.is_file ? std::filesystem::path(source.name).parent_path() : "";
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

void ReadBasics(ConfigMap& map, Scenario* scenario, Mistakes* mistakes) {
  ScenarioBasics::VisitFields(*scenario, PatientFieldReader(&map, mistakes));
  const auto name = map.Optional("name");
  if (name && name->tree().kind == ConfigKind::kScalar) {
    mistakes->Try([&] { name->Word(); });  // it becomes a folder's
  }
}

/// Reads the sections: structs as they are, and what files spell in a form of its own. Goes on
/// after mistakes.
class SectionReader {
 public:
  SectionReader(ConfigMap* map, const RobotDescription* robot, std::vector<PushEntry>* pushes,
                Mistakes* mistakes)
      : map_(map), robot_(robot), pushes_(pushes), mistakes_(mistakes) {}

  template <typename T>
  void operator()(const char* key, T& section, Meaning /*meaning*/) {
    if (const auto node = map_->Optional(key)) {
      mistakes_->Try([&] { Read(*node, &section); });
    }
  }
  void operator()(const char* key, std::vector<GaitParams>& gaits, Meaning /*meaning*/) {
    mistakes_->Try([&] { gaits = ReadGaits(map_->Optional(key), *robot_); });
  }

 private:
  template <typename T>
  void Read(const ConfigNode& node, T* section) {
    ReadFields(node, *section);
  }
  void Read(const ConfigNode& node, std::vector<Push>* /*pushes*/) { *pushes_ = ReadPushes(node); }
  void Read(const ConfigNode& node, std::vector<Expectation>* expect) {
    *expect = ReadExpectations(node);
  }
  void Read(const ConfigNode& node, VideoParams* video) { *video = ReadVideo(node); }

  ConfigMap* map_;
  const RobotDescription* robot_;
  std::vector<PushEntry>* pushes_;  ///< What they come to, only the whole scenario tells.
  Mistakes* mistakes_;
};

/// `file` is empty of a scenario that has none.
Scenario ReadTree(ConfigTree root, const std::filesystem::path& file,
                  const std::vector<std::string>& overrides, const NoteSink& note,
                  const RobotReader& read_robot) {
  ConfigMap map(root, "");
  RenameOldKeys(&root, note);
  for (const std::string& assignment : overrides) ApplyOverride(assignment, &root, note);
  RejectBaseOfOverride(root);

  Scenario scenario;
  scenario.file = file;
  scenario.overrides = overrides;
  CheckFormat(root, &map);
  Mistakes mistakes;
  ReadBasics(map, &scenario, &mistakes);
  const auto robot = map.Optional("robot");
  if (robot && robot->tree().kind == ConfigKind::kScalar) {
    mistakes.Try([&] { ReadRobot(*robot, map.Optional("control"), note, read_robot, &scenario); });
  }
  std::vector<PushEntry> pushes;
  Scenario::VisitSections(scenario, SectionReader(&map, &scenario.robot, &pushes, &mistakes));
  mistakes.Try([&] { map.RejectUnknownKeys(); });
  mistakes.Throw();  // what fits together is a question of what is right by itself
  CheckMotion(scenario, root);
  WarnOfServos(scenario, note);
  scenario.pushes = ResolvePushes(pushes, scenario, root);
  CheckSurroundings(scenario, root);
  return scenario;
}

}  // namespace

Scenario ReadScenario(const std::filesystem::path& file, const std::vector<std::string>& overrides,
                      const NoteSink& note, const RobotReader& read_robot) {
  return ReadTree(ReadWithBases(file, note), file, overrides, note, read_robot);
}

ScenarioBasics ReadScenarioBasics(const std::filesystem::path& file) {
  const ConfigTree root = ReadWithBases(file, {});
  ConfigMap map(root, "");
  CheckFormat(root, &map);
  ScenarioBasics basics;
  Mistakes mistakes;
  ScenarioBasics::VisitFields(basics, PatientFieldReader(&map, &mistakes));
  mistakes.Throw();
  return basics;
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
  return IsConfigFileWith("sidestep_robot", word);
}

}  // namespace sidestep
