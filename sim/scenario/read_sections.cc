// SPDX-License-Identifier: BSD-3-Clause
#include "sim/scenario/read_sections.h"

#include <array>
#include <string>

#include "models/support/config_error.h"
#include "models/support/nearest_name.h"
#include "sim/scenario/read_fields.h"
#include "sim/verdict/metrics.h"

namespace sidestep {
namespace {

constexpr double kMaxMetric = 1e12;  // only catches slips of the pen

// Feet that can't be set elsewhere are as far apart as they are.
GaitParams DefaultGait(const RobotDescription& robot) {
  GaitParams gait;
  const bool is_planar = robot.base_freedom == BaseFreedom::kSagittal;
  if (is_planar) gait.step_width_m = 2.0 * robot.feet.front().lateral_m;
  if (robot.feet.size() == 1) gait.step_width_m = 0.0;
  return gait;
}

GaitParams ReadGait(const ConfigNode& node, const GaitParams& defaults) {
  GaitParams gait = defaults;
  ReadFields(node, gait);
  return gait;
}

/// Refuses two ways to tell the force, and none.
void CheckForce(const PushEntry& entry, ConfigMap& map, const ConfigNode& node) {
  constexpr std::array kSizes{"magnitude_N", "magnitude_mg", "impulse_Nspkg"};
  const char* size_key = nullptr;
  for (const char* key : kSizes) {
    const auto size = map.Optional(key);
    if (!size) continue;
    const char* rival = entry.force_N ? "force_N" : size_key;
    if (rival != nullptr) size->Fail("and " + std::string(rival) + " exclude each other");
    size_key = key;
  }
  const auto direction = map.Optional("direction_rad");
  if (entry.force_N) {
    if (direction) direction->Fail("and force_N exclude each other");
    return;
  }
  if (size_key == nullptr && !direction) {
    node.Fail(
        "needs force_N, or direction_rad and one of magnitude_N, magnitude_mg, "
        "impulse_Nspkg");
  }
  if (size_key == nullptr) map.Required(kSizes.front());
  map.Required("direction_rad");
  const auto frame = map.Optional("frame");
  if (frame && entry.push.frame != PushFrame::kHeading) {
    frame->Fail("must be heading, or absent, where direction_rad is given");
  }
}

/// Likewise of the start.
void CheckStart(const PushEntry& entry, ConfigMap& map) {
  if (!entry.at_phase) {
    map.Required("start_s");
    for (const char* key : {"foot", "after_s"}) {
      if (const auto other = map.Optional(key)) other->Fail("goes with at_phase, which is absent");
    }
  } else if (entry.start_s) {
    map.Required("at_phase").Fail("and start_s exclude each other");
  }
}

PushEntry ReadPush(const ConfigNode& node) {
  ConfigMap map = node.Map();
  PushEntry entry;
  Mistakes mistakes;
  PushEntry::VisitFields(entry, PatientFieldReader(&map, &mistakes));
  mistakes.Try([&] { CheckForce(entry, map, node); });
  mistakes.Try([&] { CheckStart(entry, map); });
  mistakes.Try([&] { map.RejectUnknownKeys(); });
  mistakes.Throw();
  return entry;
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

}  // namespace

std::vector<GaitParams> ReadGaits(const std::optional<ConfigNode>& node,
                                  const RobotDescription& robot) {
  const GaitParams defaults = DefaultGait(robot);
  if (!node) return {defaults};
  if (node->tree().kind == ConfigKind::kMap) return {ReadGait(*node, defaults)};
  if (node->tree().kind != ConfigKind::kList) node->Fail("must be a map of keys or a list of them");
  std::vector<GaitParams> gaits;
  ForEachElement(*node,
                 [&](const ConfigNode& element) { gaits.push_back(ReadGait(element, defaults)); });
  if (gaits.empty()) node->Fail("must hold at least one gait");
  return gaits;
}

std::vector<PushEntry> ReadPushes(const ConfigNode& node) {
  std::vector<PushEntry> pushes;
  ForEachElement(node, [&](const ConfigNode& element) { pushes.push_back(ReadPush(element)); });
  return pushes;
}

std::vector<Expectation> ReadExpectations(const ConfigNode& node) {
  ConfigMap map = node.Map();
  std::vector<Expectation> expectations;
  Mistakes mistakes;
  for (const std::string& name : map.Keys()) {
    mistakes.Try([&] {
      const MetricInfo& metric = ReadMetric(map, name);
      expectations.push_back(ReadExpectation(map.Required(name), metric));
    });
  }
  mistakes.Throw();
  return expectations;
}

VideoParams ReadVideo(const ConfigNode& node) {
  VideoParams video;
  if (node.is_bool()) {
    video.enabled = node.Bool();
    return video;
  }
  ReadFields(node, video);
  return video;
}

}  // namespace sidestep
