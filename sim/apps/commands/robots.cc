// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <memory>

#include "models/import/embedded_robot.h"
#include "models/robot_description/robot_faults.h"
#include "models/support/config_error.h"
#include "sim/apps/commands/commands.h"
#include "sim/apps/commands/exit_code.h"
#include "sim/apps/commands/out_folder.h"
#include "sim/apps/commands/print_robot.h"
#include "sim/process/interrupt.h"
#include "sim/world/world_model.h"

namespace sidestep {
namespace {

struct RobotsArguments {
  std::string robot;  ///< Empty: list all.
  std::filesystem::path mjcf;
};

RobotDescription Describe(const std::string& robot) {
  const EndsAtOnce reading(kExitInvalid);
  const std::filesystem::path file = FindRobot(robot, std::filesystem::current_path());
  if (!file.empty()) return ReadSoundRobot(file);
  std::string shipped;
  for (const std::string& name : ShippedRobots()) shipped += (shipped.empty() ? "" : ", ") + name;
  throw ConfigError("error: there is no robot '" + robot + "'; shipped: " + shipped);
}

std::string Listed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

void Print(const RobotDescription& robot) {
  std::vector<std::string> feet;
  for (const FootDescription& foot : robot.feet) feet.push_back(foot.name);
  const RobotNames names = NamesIn(robot);
  std::printf("%s\n", robot.name.c_str());
  std::printf("  file    %s\n", robot.file.c_str());
  std::printf("  model   %s\n",
              robot.model ? robot.model->file.c_str() : "none: for the centroidal plant only");
  std::printf("  feet    %s\n", Listed(feet).c_str());
  PrintRobotFigures(robot);
  std::printf("  bodies  %s\n", Listed(names.bodies).c_str());
  std::printf("  frames  %s\n", Listed(names.frames).c_str());
  for (const std::string& notice : robot.notices) std::printf("%s\n", notice.c_str());
}

// The world as a scenario with only defaults compiles it: robot, floor, light. It carries the
// robot's files, so that an import of it is the same robot.
std::string ExportText(const RobotDescription& robot) {
  const EndsAtOnce compiling(kExitInvalid);
  return importer::WithRobotFiles(DrawnWorldMjcf(robot), robot);
}

void SaveMjcf(const RobotDescription& robot, const std::filesystem::path& file) {
  WriteTextFile(file, ExportText(robot));
  std::printf("%s\n", file.c_str());
}

int Robots(const RobotsArguments& arguments) {
  if (arguments.robot.empty()) {
    if (!arguments.mjcf.empty()) throw ConfigError("error: --mjcf needs a robot");
    for (const std::string& name : ShippedRobots()) std::printf("%s\n", name.c_str());
    return kExitPass;
  }
  const RobotDescription robot = Describe(arguments.robot);
  if (arguments.mjcf.empty()) {
    const EndsAtOnce computing(kExitInvalid);
    Print(robot);
  } else {
    SaveMjcf(robot, arguments.mjcf);
  }
  return kExitPass;
}

}  // namespace

void AddRobotsCommand(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("robots", "List the robots that ship, or tell of one");
  const auto arguments = std::make_shared<RobotsArguments>();
  command->add_option("ROBOT", arguments->robot, "A shipped robot, or a path to a robot.yaml");
  command->add_option("--mjcf", arguments->mjcf, "Write its MJCF, with what is only drawn")
      ->type_name("FILE");
  AddRobotsImportCommand(*command, exit_code);
  command->callback([command, arguments, &exit_code] {
    if (command->get_subcommands().empty()) exit_code = Robots(*arguments);
  });
}

}  // namespace sidestep
