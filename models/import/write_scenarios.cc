// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/write_scenarios.h"

#include "models/import/text.h"
#include "models/import/write_robot_yaml.h"
#include "models/robot_description/home_pose.h"
#include "models/robot_description/robot_figures.h"

namespace sidestep::importer {
namespace {

constexpr double kPush_Nspkg =
    0.15;  // a shove that any of the shipped humanoids takes in its stride

std::string Head(const ImportedRobot& imported, const std::string& what, const std::string& says,
                 const char* duration_s) {
  return "# Written by sidestep robots import.\nsidestep: 1\nname: " + imported.name + "_" + what +
         "\ndescription: " + imported.name + " " + says +
         "\nrobot: robot.yaml\nduration_s: " + duration_s + "\n";
}

std::string WalkText(const Gait& gait) {
  const std::string width = ", step_width_m: " + Figure(gait.step_width_m);
  const std::string stand =
      gait.stands ? "  - {type: stand, start_s: 0.0" + width + "}\n" : std::string();
  return "gait:\n" + stand + "  - {type: walk, start_s: " + (gait.stands ? "1.0" : "0.0") +
         ", step_length_m: " + Figure(gait.step_length_m) + width +
         ",\n     swing_s: " + Figure(gait.swing_s) +
         ", double_support_s: " + Figure(gait.double_support_s) +
         ", swing_height_m: " + Figure(gait.swing_height_m) +
         ", landing_speed_mps: " + Figure(gait.landing_speed_mps) + "}\n";
}

Gait InPlace(Gait gait) {
  gait.step_length_m = 0.0;
  return gait;
}

constexpr char kWorld[] = "world: {friction: 0.8}\nexpect:\n  fall: false\n";

}  // namespace

std::map<std::string, std::string> ScenarioTexts(const ImportedRobot& imported) {
  const std::string& name = imported.name;
  const Gait& gait = imported.gait;
  std::map<std::string, std::string> texts;
  texts[name + "_stand.yaml"] =
      gait.stands
          ? Head(imported, "stand", "stands.", "10.0") +
                "gait: {type: stand, step_width_m: " + Figure(gait.step_width_m) + "}\n" + kWorld +
                "  max_slip_m: {max: 0.005}\n"
          : Head(imported, "stand", "steps in place, as no robot stands still on points.", "10.0") +
                WalkText(InPlace(gait)) + kWorld + "  max_slip_m: {max: 0.02}\n";
  texts[name + "_walk.yaml"] = Head(imported, "walk", "walks.", "10.0") + WalkText(gait) + kWorld +
                               "  max_slip_m: {max: 0.02}\n";
  texts[name + "_push.yaml"] =
      Head(imported, "push", "walks and is pushed to its left.", "10.0") + WalkText(gait) +
      "pushes:\n  - {body: " + YamlText(imported.Link(imported.robot.root)) +
      ", impulse_Nspkg: " + Figure(kPush_Nspkg) +
      ", direction_rad: 1.571, at_phase: mid_stance, foot: left, after_s: 4.0, duration_s: 0.1}\n" +
      kWorld + "  recovered: true\n";
  return texts;
}

std::map<std::string, std::string> ScenariosOf(const RobotDescription& robot) {
  if (!robot.model || robot.feet.size() != 2 || robot.joints.empty()) return {};
  const bool on_points = robot.feet[0].vertices_m.cols() == 1;
  if (robot.base_freedom != BaseFreedom::kFree || robot.feet[0].vertices_m.cols() == 2) return {};
  const HomePose home(robot);
  const RobotFigures figures = FiguresOf(robot);
  ImportedRobot stand_in;  // of what its scenarios are made from
  stand_in.name = robot.name;
  stand_in.robot.links.resize(1);
  stand_in.robot.links[0].name = robot.base;
  StartPose start;
  start.com_height_m = figures.com_height_m;
  start.leg_length_m = figures.soles[0].leg_length_m;
  start.step_width_m =
      (home.X_WO(robot.feet[0].frame).translation() - home.X_WO(robot.feet[1].frame).translation())
          .norm();
  stand_in.gait = ChooseGait(start, on_points);
  return ScenarioTexts(stand_in);
}

}  // namespace sidestep::importer
