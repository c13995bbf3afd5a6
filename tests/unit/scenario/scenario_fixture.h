// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// scenario_fixture: a valid scenario, and what reading an edited copy of it gives.

#include <gtest/gtest.h>
#include <stdlib.h>

#include <filesystem>
#include <string>
#include <vector>

#include "sim/scenario/read_scenario.h"
#include "tests/support/temp_folder.h"

namespace sidestep {

/// Stands for what ships with the program, for the length of a test.
inline std::filesystem::path FixtureData() {
  return std::filesystem::path(SIDESTEP_SOURCE_DIR) / "tests/data";
}

/// Robots `mini` (MJCF, one foot), `point` and `walker` (centroidal; one foot, two feet).
inline std::filesystem::path FixtureRobots() { return FixtureData() / "models"; }

class ScenarioFixture : public testing::Test {
 protected:
  ScenarioFixture() { setenv("SIDESTEP_DATA_DIR", FixtureData().c_str(), 1); }
  ~ScenarioFixture() override { unsetenv("SIDESTEP_DATA_DIR"); }

  Scenario Read(const std::string& text, const std::vector<std::string>& overrides = {}) const {
    return ReadScenario(folder_.Write("a.yaml", text), overrides);
  }

  /// The error of reading `text`; its file is called a.yaml.
  std::string ErrorIn(const std::string& text,
                      const std::vector<std::string>& overrides = {}) const {
    return folder_.ErrorOf([&] { Read(text, overrides); });
  }

  /// The error of the valid scenario after one edit.
  std::string ErrorOfEdit(const std::string& from, const std::string& to) const {
    return ErrorIn(Edit(valid_, from, to));
  }

  /// The error of the valid scenario under one override.
  std::string ErrorOfSet(const std::string& assignment) const {
    return ErrorIn(valid_, {assignment});
  }

  const std::string valid_ =
      "sidestep: 1\n"
      "name: hop\n"
      "robot: mini\n"
      "plant: mujoco\n"
      "duration_s: 6\n"
      "seed: 7\n"
      "control:\n"
      "  mode: torque\n"
      "  rate_hz: 500\n"
      "  mpc: {rate_hz: 20, knots: 12, step_s: 0.05, box_lower_m: [-0.1, -0.2, 0]}\n"
      "gait: {type: hop, stance_s: 0.25, step_width_m: 0}\n"
      "pushes:\n"
      "  - {body: trunk, force_N: [0, 5, 0], start_s: 2, duration_s: 0.5, point_m: [0, 0, 0.1]}\n"
      "  - {body: foot, magnitude_N: 2, direction_rad: 0, start_s: 4, duration_s: 0.1}\n"
      "world: {friction: 0.9}\n"
      "expect:\n"
      "  fall: false\n"
      "  max_tilt_rad: {max: 0.5}\n"
      "video: {size: [320, 240], fps: 25, camera: fixed}\n";
  const TempFolder folder_;
};

}  // namespace sidestep
