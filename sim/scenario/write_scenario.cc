// SPDX-License-Identifier: BSD-3-Clause
#include "sim/scenario/write_scenario.h"

#include <algorithm>

#include "sim/scenario/yaml_writer.h"

namespace sidestep {
namespace {

std::string RobotReference(const Scenario& scenario) {
  const std::vector<std::string> shipped = ShippedRobots();
  const bool is_shipped =
      std::find(shipped.begin(), shipped.end(), scenario.robot) != shipped.end();
  return is_shipped ? scenario.robot : scenario.description_of_robot.file.string();
}

void WriteBasics(const Scenario& scenario, YamlWriter* yaml) {
  yaml->Line("sidestep", "1");
  yaml->Line("name", YamlScalar(scenario.name));
  yaml->Line("description", YamlScalar(scenario.description));
  yaml->Line("robot", YamlScalar(RobotReference(scenario)));
  yaml->Line("plant", EnumName(scenario.plant));
  yaml->Line("duration_s", NumberText(scenario.duration_s));
  yaml->Line("seed", std::to_string(scenario.seed));
}

void WriteGaits(const std::vector<GaitParams>& gaits, YamlWriter* yaml) {
  yaml->Begin("gait");
  for (const GaitParams& gait : gaits) {
    yaml->BeginElement();
    yaml->Fields(gait);
    yaml->EndElement();
  }
  yaml->End();
}

void WritePushes(const std::vector<Push>& pushes, YamlWriter* yaml) {
  if (pushes.empty()) {
    yaml->Line("pushes", "[]");
    return;
  }
  yaml->Begin("pushes");
  for (const Push& push : pushes) {
    yaml->BeginElement();
    yaml->Line("body", YamlScalar(push.body));
    yaml->Line("force_N", YamlVector(push.force_N));
    yaml->Line("start_s", NumberText(push.start_s));
    yaml->Line("duration_s", NumberText(push.duration_s));
    yaml->Line("point_m", YamlVector(push.point_m));
    yaml->Line("profile", EnumName(push.profile));
    yaml->Line("frame", EnumName(push.frame));
    yaml->EndElement();
  }
  yaml->End();
}

void WriteExpectations(const std::vector<Expectation>& expectations, YamlWriter* yaml) {
  if (expectations.empty()) {
    yaml->Line("expect", "{}");
    return;
  }
  yaml->Begin("expect");
  for (const Expectation& expectation : expectations) {
    if (expectation.is) {
      yaml->Line(expectation.metric, *expectation.is ? "true" : "false");
      continue;
    }
    std::string interval;
    if (expectation.min) interval = "min: " + NumberText(*expectation.min);
    if (expectation.min && expectation.max) interval += ", ";
    if (expectation.max) interval += "max: " + NumberText(*expectation.max);
    yaml->Line(expectation.metric, "{" + interval + "}");
  }
  yaml->End();
}

void WriteVideo(const VideoParams& video, YamlWriter* yaml) {
  if (!video.enabled) {
    yaml->Line("video", "false");
    return;
  }
  yaml->Begin("video");
  yaml->Line("size",
             "[" + std::to_string(video.width_px) + ", " + std::to_string(video.height_px) + "]");
  yaml->Line("fps", std::to_string(video.fps));
  yaml->Line("camera", EnumName(video.camera));
  yaml->End();
}

}  // namespace

std::string ResolvedYaml(const Scenario& scenario) {
  YamlWriter yaml;
  WriteBasics(scenario, &yaml);
  yaml("control", scenario.control);
  WriteGaits(scenario.gait, &yaml);
  WritePushes(scenario.pushes, &yaml);
  yaml("world", scenario.world);
  yaml("sensors", scenario.sensors);
  yaml("verdict", scenario.verdict);
  WriteExpectations(scenario.expect, &yaml);
  WriteVideo(scenario.video, &yaml);
  return yaml.text();
}

}  // namespace sidestep
