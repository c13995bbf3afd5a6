// SPDX-License-Identifier: BSD-3-Clause
// What a run's log of each detail costs on disk, and that none of them changes the run.

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "sim/episode/run_scenario.h"
#include "sim/record/run_summary.h"
#include "sim/scenario/read_scenario.h"
#include "tests/support/run_files.h"
#include "tests/support/temp_folder.h"

namespace sidestep {
namespace {

// Every metric with the bits of its value.
std::map<std::string, std::string> MetricBits(const RunSummary& summary) {
  std::map<std::string, std::string> bits;
  for (const auto& [name, value] : summary.metrics) {
    std::visit(
        [&](auto held) {
          std::string& text = bits[name];
          text.resize(sizeof held);
          std::memcpy(text.data(), &held, sizeof held);
        },
        value);
  }
  return bits;
}

struct Logged {
  RunSummary summary;
  std::string states;
  std::uintmax_t trajectory_bytes{0};
};

Logged Run(const Scenario& scenario, LogDetail detail) {
  const TempFolder folder;
  RunOptions options;
  options.out_dir = folder.path();
  options.log = detail;
  RunScenario(scenario, options);
  const std::filesystem::path trajectory = folder.path() / "trajectory.csv";
  Logged logged{ReadSummary(folder.path()), TextOf(folder.path() / "states.bin"), 0};
  if (std::filesystem::exists(trajectory)) {
    logged.trajectory_bytes = std::filesystem::file_size(trajectory);
  }
  return logged;
}

void ExpectAQuarterAndNoOtherMetric(const std::string& name) {
  const Scenario scenario =
      ReadScenario(std::filesystem::path(SIDESTEP_SOURCE_DIR) / "scenarios" / (name + ".yaml"), {});
  const Logged full = Run(scenario, LogDetail::kFull);
  const Logged normal = Run(scenario, LogDetail::kNormal);
  const Logged none = Run(scenario, LogDetail::kNone);
  EXPECT_GT(normal.trajectory_bytes, 0U);
  EXPECT_LE(4 * normal.trajectory_bytes, full.trajectory_bytes);
  EXPECT_EQ(none.trajectory_bytes, 0U);
  EXPECT_EQ(normal.states, full.states);
  EXPECT_EQ(none.states, "");
  for (const Logged* other : {&normal, &none}) {
    EXPECT_EQ(other->summary.verdict, full.summary.verdict);
    EXPECT_EQ(MetricBits(other->summary), MetricBits(full.summary));
  }
}

TEST(LogsTest, AHoppersNormalLogIsAQuarterOfItsFullOne) {
  ExpectAQuarterAndNoOtherMetric("hopper_push");
}

TEST(LogsTest, AnIcubsNormalLogIsAQuarterOfItsFullOne) {
  ExpectAQuarterAndNoOtherMetric("icub_stand_push");
}

}  // namespace
}  // namespace sidestep
