// SPDX-License-Identifier: BSD-3-Clause
#include "sim/report/run_evidence.h"

#include <yaml-cpp/yaml.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <sstream>

#include "models/support/config_error.h"
#include "sim/plot/plot_run.h"
#include "sim/record/run_reader.h"

namespace sidestep::report {
namespace {

// The settings that people compare first; the whole scenario is below them on the page.
constexpr std::array<const char*, 14> kKeySettings{"robot",
                                                   "plant",
                                                   "duration_s",
                                                   "seed",
                                                   "control.mode",
                                                   "control.rate_hz",
                                                   "control.external_wrench",
                                                   "control.mpc.backend",
                                                   "control.mpc.rate_hz",
                                                   "control.mpc.knots",
                                                   "control.mpc.step_s",
                                                   "control.mpc.latency_s",
                                                   "world.friction",
                                                   "world.step_s"};

// The scalar at a dotted key, or nothing.
std::string ScalarAt(const YAML::Node& root, const std::string& dotted) {
  YAML::Node node = YAML::Clone(root);
  std::istringstream keys(dotted);
  for (std::string key; std::getline(keys, key, '.');) {
    if (!node.IsMap() || !node[key]) return {};
    node.reset(node[key]);
  }
  return node.IsScalar() ? node.Scalar() : std::string();
}

void ReadSettings(const std::filesystem::path& file, RunEvidence* run) {
  try {
    const YAML::Node root = YAML::Load(run->scenario_yaml);
    run->description = ScalarAt(root, "description");
    for (const char* key : kKeySettings) {
      const std::string value = ScalarAt(root, key);
      if (!value.empty()) run->settings.emplace_back(key, value);
    }
  } catch (const YAML::Exception& failure) {
    throw ConfigError(file.string(), failure.mark.line + 1, failure.mark.column + 1, failure.msg);
  }
}

}  // namespace

RunEvidence LoadEvidence(const std::filesystem::path& run_dir) {
  RunEvidence run;
  run.dir = run_dir;
  run.summary = ReadSummary(run_dir);
  run.scenario_yaml = ReadWholeFile(run_dir / "scenario.yaml");
  ReadSettings(run_dir / "scenario.yaml", &run);
  if (std::filesystem::exists(run_dir / "video.mp4")) {
    run.video = ReadWholeFile(run_dir / "video.mp4");
  }
  for (const std::string& plot : PlotNames()) {
    const std::filesystem::path file = run_dir / "plots" / (plot + ".svg");
    if (std::filesystem::exists(file)) run.plots.emplace_back(plot, ReadWholeFile(file));
  }
  return run;
}

std::string Readable(double value) {
  if (!std::isfinite(value)) return "–";
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

std::string Readable(bool value) { return value ? "yes" : "no"; }

std::string Readable(const MetricValue& value) {
  return std::visit([](auto held) { return Readable(held); }, value);
}

}  // namespace sidestep::report
