// SPDX-License-Identifier: BSD-3-Clause
#include "sim/scenario/read_sections.h"

#include <cmath>
#include <string>

#include "models/support/nearest_name.h"
#include "sim/scenario/read_fields.h"
#include "sim/verdict/metrics.h"

namespace sidestep {
namespace {

// Bounds that only catch slips of the pen, such as millimetres for metres.
constexpr double kMaxForce_N = 1e5;
constexpr double kMaxPoint_m = 10.0;
constexpr double kMaxTime_s = 1e4;
constexpr double kMaxAngle_rad = 7.0;  // a turn and a bit
constexpr double kMaxMetric = 1e12;
constexpr int kMinVideo_px = 64;
constexpr int kMaxVideo_px = 4096;
constexpr int kMaxFps = 240;

GaitParams DefaultGait(std::size_t foot_count) {
  GaitParams gait;
  if (foot_count == 1) gait.step_width_m = 0.0;
  return gait;
}

GaitParams ReadGait(const ConfigNode& node, std::size_t foot_count) {
  GaitParams gait = DefaultGait(foot_count);
  ReadFields(node, gait);
  return gait;
}

void ReadForce(ConfigMap& map, const ConfigNode& node, Push* push) {
  const auto force = map.Optional("force_N");
  const auto magnitude = map.Optional("magnitude_N");
  const auto direction = map.Optional("direction_rad");
  if (force) {
    if (magnitude) magnitude->Fail("and force_N exclude each other");
    if (direction) direction->Fail("and force_N exclude each other");
    push->force_N = force->Vector3(-kMaxForce_N, kMaxForce_N);
    return;
  }
  if (!magnitude && !direction) node.Fail("needs force_N, or magnitude_N and direction_rad");
  const double magnitude_N = map.Required("magnitude_N").Number(0.0, kMaxForce_N);
  const double direction_rad = map.Required("direction_rad").Number(-kMaxAngle_rad, kMaxAngle_rad);
  push->force_N =
      magnitude_N * Eigen::Vector3d(std::cos(direction_rad), std::sin(direction_rad), 0);
  push->frame = PushFrame::kHeading;
  const auto frame = map.Optional("frame");
  if (frame && ReadEnum<PushFrame>(*frame) != PushFrame::kHeading) {
    frame->Fail("must be heading, or absent, where direction_rad is given");
  }
}

Push ReadPush(const ConfigNode& node) {
  ConfigMap map = node.Map();
  Push push;
  push.body = map.Required("body").Text();
  push.start_s = map.Required("start_s").Number(0.0, kMaxTime_s);
  const ConfigNode duration = map.Required("duration_s");
  push.duration_s = duration.Number(0.0, kMaxTime_s);
  if (push.duration_s <= 0.0) duration.Fail("must be greater than 0");
  if (const auto frame = map.Optional("frame")) push.frame = ReadEnum<PushFrame>(*frame);
  if (const auto profile = map.Optional("profile")) push.profile = ReadEnum<PushProfile>(*profile);
  if (const auto point = map.Optional("point_m")) {
    push.point_m = point->Vector3(-kMaxPoint_m, kMaxPoint_m);
  }
  ReadForce(map, node, &push);
  map.RejectUnknownKeys();
  return push;
}

const MetricInfo& ReadMetric(const ConfigMap& map, const std::string& name) {
  const MetricInfo* metric = FindMetric(name);
  if (metric != nullptr) return *metric;
  std::vector<std::string> known;
  for (const MetricInfo& candidate : KnownMetrics()) known.emplace_back(candidate.name);
  map.FailAtKey(name, "is not a known metric; " + DidYouMean(name, known, "known metrics"));
}

void ReadInterval(const ConfigNode& node, Expectation* expectation) {
  ConfigMap map = node.Map();
  if (const auto min = map.Optional("min")) expectation->min = min->Number(-kMaxMetric, kMaxMetric);
  if (const auto max = map.Optional("max")) expectation->max = max->Number(-kMaxMetric, kMaxMetric);
  map.RejectUnknownKeys();
  if (!expectation->min && !expectation->max) node.Fail("needs min, max or both");
  if (expectation->min && expectation->max && *expectation->min > *expectation->max) {
    node.Fail("has min = " + NumberText(*expectation->min) +
              " above max = " + NumberText(*expectation->max));
  }
}

Expectation ReadExpectation(const ConfigNode& node, const MetricInfo& metric) {
  Expectation expectation;
  expectation.metric = metric.name;
  if (metric.is_bool) {
    expectation.is = node.Bool();
  } else if (node.is_bool()) {
    node.Fail("must be a number or {min, max}: this metric is not true or false");
  } else if (node.tree().kind == ConfigKind::kMap) {
    ReadInterval(node, &expectation);
  } else {
    expectation.min = expectation.max = node.Number(-kMaxMetric, kMaxMetric);
  }
  return expectation;
}

int ReadSide(const ConfigNode& node) {
  const int side_px = static_cast<int>(node.Integer(kMinVideo_px, kMaxVideo_px));
  if (side_px % 2 != 0) node.Fail("= " + node.Text() + " must be even, as H.264 asks");
  return side_px;
}

}  // namespace

std::vector<GaitParams> ReadGaits(const std::optional<ConfigNode>& node, std::size_t foot_count) {
  if (!node) return {DefaultGait(foot_count)};
  if (node->tree().kind == ConfigKind::kMap) return {ReadGait(*node, foot_count)};
  if (node->tree().kind != ConfigKind::kList) node->Fail("must be a map of keys or a list of them");
  std::vector<GaitParams> gaits;
  for (const ConfigNode& element : node->List()) gaits.push_back(ReadGait(element, foot_count));
  if (gaits.empty()) node->Fail("must hold at least one gait");
  return gaits;
}

std::vector<Push> ReadPushes(const ConfigNode& node) {
  std::vector<Push> pushes;
  for (const ConfigNode& element : node.List()) pushes.push_back(ReadPush(element));
  return pushes;
}

std::vector<Expectation> ReadExpectations(const ConfigNode& node) {
  ConfigMap map = node.Map();
  std::vector<Expectation> expectations;
  for (const std::string& name : map.Keys()) {
    const MetricInfo& metric = ReadMetric(map, name);
    expectations.push_back(ReadExpectation(map.Required(name), metric));
  }
  return expectations;
}

VideoParams ReadVideo(const ConfigNode& node) {
  VideoParams video;
  if (node.is_bool()) {
    video.enabled = node.Bool();
    return video;
  }
  ConfigMap map = node.Map();
  if (const auto size = map.Optional("size")) {
    const std::vector<ConfigNode> sides = size->List();
    if (sides.size() != 2) size->Fail("must be a list of 2 integers, [width, height] in pixels");
    video.width_px = ReadSide(sides[0]);
    video.height_px = ReadSide(sides[1]);
  }
  if (const auto fps = map.Optional("fps")) video.fps = static_cast<int>(fps->Integer(1, kMaxFps));
  if (const auto camera = map.Optional("camera")) video.camera = ReadEnum<VideoCamera>(*camera);
  map.RejectUnknownKeys();
  return video;
}

}  // namespace sidestep
