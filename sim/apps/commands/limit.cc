// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "models/robot_description/home_pose.h"
#include "models/support/config_error.h"
#include "sim/apps/commands/commands.h"
#include "sim/apps/commands/exit_code.h"
#include "sim/apps/commands/out_folder.h"
#include "sim/limit/assume.h"
#include "sim/limit/limit_subject.h"
#include "sim/limit/limit_table.h"
#include "sim/process/interrupt.h"
#include "sim/scenario/find_scenario.h"
#include "sim/scenario/read_scenario.h"

namespace sidestep {
namespace {

constexpr int kMostDirections = 360;
constexpr int kMostMoments = 100;
constexpr const char* kNamedMoments = "named";

struct LimitArguments {
  std::string subject;
  std::vector<std::string> overrides;
  std::vector<std::string> assumptions;
  limit::StepFreedom freedom{limit::StepFreedom::kFree};
  int directions{16};
  std::string moments{"8"};
  double push_s{0.1};
  std::string part;
  std::filesystem::path out;
  bool force{false};
};

bool IsShippedRobot(const std::string& word) {
  const std::vector<std::string> shipped = ShippedRobots();
  return std::find(shipped.begin(), shipped.end(), word) != shipped.end();
}

// A robot that ships, the robot.yaml of another, or else a scenario.
Scenario Read(const LimitArguments& arguments) {
  if (IsShippedRobot(arguments.subject) || IsRobotFile(arguments.subject)) {
    return ScenarioOfRobot(arguments.subject, arguments.overrides, PrintNote);
  }
  return ReadScenario(FindScenario(arguments.subject), arguments.overrides, PrintNote);
}

std::optional<limit::PushedPart> PartOf(const LimitArguments& arguments, const Scenario& scenario) {
  if (arguments.part.empty()) return std::nullopt;
  const HomePose home(scenario.robot);
  const double height_m = home.X_WO(arguments.part).translation().z();
  if (height_m <= 0.0) {
    throw ConfigError("error: --at " + arguments.part + " is not above the ground");
  }
  return limit::PushedPart{arguments.part, height_m / scenario.robot.com_height_m};
}

std::vector<limit::PushMoment> MomentsOf(const LimitArguments& arguments,
                                         const limit::LimitTask& task) {
  if (arguments.moments == kNamedMoments) return limit::NamedMoments(task.params, task.gait);
  return limit::EvenMoments(task.params, task.gait, std::stoi(arguments.moments));
}

limit::LimitTable TableOf(const LimitArguments& arguments) {
  const EndsAtOnce computing(kExitInvalid);
  const Scenario scenario = Read(arguments);
  const limit::LimitSubject subject = limit::LimitSubjectOf(scenario);
  limit::LimitTask task;
  task.params = limit::Assume(arguments.assumptions, subject.params);
  task.gait = subject.gait;
  task.is_planar = subject.is_planar;
  task.freedom = arguments.freedom;
  task.moments = MomentsOf(arguments, task);
  task.directions_rad = limit::EvenDirections(arguments.directions, subject.is_planar);
  return limit::MakeLimitTable(arguments.subject, task, arguments.push_s,
                               PartOf(arguments, scenario));
}

int Limit(const LimitArguments& arguments) {
  if (!arguments.out.empty()) CheckOutFile(arguments.out, arguments.force);
  const limit::LimitTable table = TableOf(arguments);
  if (!arguments.out.empty()) WriteTextFile(arguments.out, LimitCsv(table));
  std::fputs(LimitText(table).c_str(), stdout);
  return kExitPass;
}

// What --steps may say, as EnumNames has it.
CLI::IsMember FreedomNames() {
  std::vector<std::string> names;
  for (const auto freedom : EnumValues<limit::StepFreedom>()) names.emplace_back(EnumName(freedom));
  return CLI::IsMember(names);
}

CLI::Validator CountOrNamed() {
  return {[](std::string& text) {
            int count = 0;
            const bool is_count =
                CLI::detail::lexical_cast(text, count) && count >= 1 && count <= kMostMoments;
            return is_count || text == kNamedMoments
                       ? ""
                       : text + " is neither a number from 1 to " + std::to_string(kMostMoments) +
                             " nor '" + kNamedMoments + "'";
          },
          ""};
}

void AddOptions(CLI::App& command, const std::shared_ptr<LimitArguments>& arguments) {
  command
      .add_option("SUBJECT", arguments->subject,
                  "A scenario, or a robot, which comes first: it walks in place then, or hops")
      ->type_name("ROBOT|SCENARIO")
      ->required();
  command
      .add_option_function<std::string>(
          "--steps",
          [arguments](const std::string& name) {
            if (const auto freedom = EnumOfName<limit::StepFreedom>(name)) {
              arguments->freedom = *freedom;
            }
          },
          "What may change of them: none, their places, or times too (free)")
      ->check(FreedomNames())
      ->default_str(std::string(EnumName(arguments->freedom)));
  command.add_option("--directions", arguments->directions, "Of pushes, evenly spread")
      ->check(CLI::Range(1, kMostDirections))
      ->capture_default_str();
  command
      .add_option(
          "--phases", arguments->moments,
          "Moments of a step, evenly spread; or 'named': lift-off, mid swing, before landing, "
          "double support")
      ->check(CountOrNamed())
      ->capture_default_str();
  command.add_option("--push-s", arguments->push_s, "How long a push lasts (0: an instant)")
      ->check(Within(0.0, 10.0))
      ->capture_default_str();
  command.add_option("--at", arguments->part, "Body or frame that is pushed, besides the CoM")
      ->type_name("PART");
  command
      .add_option("--assume", arguments->assumptions,
                  "Replace a figure of the pendulum: reach_m=0.5, swing_speed_mps=2")
      ->type_name("KEY=VALUE")
      ->take_all()
      ->allow_extra_args(false);
  AddSetOption(command, arguments->overrides);
  command.add_option("-o,--out", arguments->out, "Write a row a direction and moment")
      ->type_name("FILE.csv");
  command.add_flag("--force", arguments->force, "Replace a file that is there");
}

}  // namespace

void AddLimitCommand(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand(
      "limit", "Tell which pushes a linear pendulum with a robot's feet could survive");
  const auto arguments = std::make_shared<LimitArguments>();
  AddOptions(*command, arguments);
  command->footer(
      "Directions: 0 ahead, 90 degrees towards the foot in the air, or the one that has just "
      "landed.\nAn upper bound for robots that turn neither trunk nor arms: infinite-step capture "
      "after Koolen et al. 2012.");
  command->callback([arguments, &exit_code] { exit_code = Limit(*arguments); });
}

}  // namespace sidestep
