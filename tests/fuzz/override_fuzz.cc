// SPDX-License-Identifier: BSD-3-Clause
// `--set a.b=c`, without its `--set`, and `--push TEXT`, one a line, on top of a scenario that
// ships.

#include <sstream>
#include <string>
#include <vector>

#include "sim/scenario/read_scenario.h"
#include "tests/fuzz/fuzz_folder.h"
#include "tests/fuzz/fuzz_reader.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace sidestep;
  static const std::filesystem::path scenario =
      std::filesystem::path(SIDESTEP_SOURCE_DIR) / "scenarios/one_leg.yaml";
  std::vector<std::string> overrides;
  std::istringstream lines(fuzz::TextOf(data, size));
  for (std::string line; std::getline(lines, line);) overrides.push_back(line);
  fuzz::IsRead([&] { ReadScenario(scenario, overrides, fuzz::RequireWords); });
  return 0;
}
