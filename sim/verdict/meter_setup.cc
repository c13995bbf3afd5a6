// SPDX-License-Identifier: BSD-3-Clause
#include "sim/verdict/meter_setup.h"

namespace sidestep {

MeterSetup MeterSetupOf(const Scenario& scenario, double mass_kg,
                        const std::vector<JointInfo>& joints) {
  return {scenario.robot,
          scenario.plant,
          AskedGaitOf(scenario),
          scenario.verdict,
          scenario.pushes,
          scenario.world.ground,
          scenario.control.rate_hz,
          scenario.control.mpc.friction,
          mass_kg,
          joints};
}

}  // namespace sidestep
