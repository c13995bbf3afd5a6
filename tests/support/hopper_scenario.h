// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// hopper_scenario: the shipped hopper, as its shipped scenario or doing nothing.

#include <filesystem>
#include <string>
#include <vector>

#include "sim/scenario/read_scenario.h"

namespace sidestep {

/// scenarios/hopper_hop.yaml: stands for 0.5 s, then hops in place, on its own noisy sensors.
inline Scenario HoppingHopper(const std::vector<std::string>& overrides = {}) {
  return ReadScenario(std::filesystem::path(SIDESTEP_SOURCE_DIR) / "scenarios/hopper_hop.yaml",
                      overrides);
}

/// The same without noise, its base at `height_m` at the start. At the default it stands.
inline Scenario PlainHopper(double height_m = 0.0) {
  Scenario scenario = HoppingHopper();
  scenario.sensors = {};
  scenario.pushes.clear();
  if (height_m > 0.0) scenario.robot.base_height_m = height_m;
  return scenario;
}

/// A constant push on the trunk, in W.
inline Push TrunkPush(const Eigen::Vector3d& force_N, double start_s, double duration_s,
                      const Eigen::Vector3d& point_m) {
  Push push;
  push.body = "trunk";
  push.force_N = force_N;
  push.start_s = start_s;
  push.duration_s = duration_s;
  push.point_m = point_m;
  return push;
}

/// Where the trunk's own centre of mass lies in it, as models/hopper/hopper.xml has it (m).
inline const Eigen::Vector3d kTrunkCom_m{0.0, 0.0, 0.02};

}  // namespace sidestep
