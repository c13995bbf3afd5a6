// SPDX-License-Identifier: BSD-3-Clause
// user_program: what links the installed libraries finds the shipped data though it lies elsewhere,
// runs a scenario, and agrees with them on how structs are laid out.

#include <cstdio>

#include "sim/episode/run_scenario.h"
#include "sim/scenario/find_scenario.h"
#include "sim/scenario/read_scenario.h"

int main() {
  const sidestep::Scenario scenario =
      sidestep::ReadScenario(sidestep::FindScenario("hopper_hop"), {});
  sidestep::RunOptions options;
  options.out_dir = "hop";
  const sidestep::RunResult result = sidestep::RunScenario(scenario, options);
  const bool has_passed = result.verdict.verdict_class == sidestep::VerdictClass::kPass;
  std::puts(has_passed ? "PASS" : "FAIL");
  return has_passed ? 0 : 1;
}
