// SPDX-License-Identifier: BSD-3-Clause
// A robot.yaml beside the models mini.xml, mini.urdf, hopper.xml and rabbit.xml, with its
// `control` block.

#include <string>

#include "models/robot_description/robot_figures.h"
#include "sim/scenario/read_scenario.h"
#include "tests/fuzz/fuzz_folder.h"
#include "tests/fuzz/fuzz_reader.h"

namespace sidestep::fuzz {
namespace {

bool WriteModels() {
  const std::filesystem::path root(SIDESTEP_SOURCE_DIR);
  for (const char* model :
       {"tests/data/models/mini/mini.xml", "tests/data/models/mini_urdf/mini.urdf",
        "models/hopper/hopper.xml", "models/rabbit/rabbit.xml"}) {
    std::filesystem::copy(root / model, InputFolder().path());
  }
  return true;
}

}  // namespace
}  // namespace sidestep::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace sidestep;
  static const bool has_models = fuzz::WriteModels();
  fuzz::Require(has_models, "no models");
  const std::string file = fuzz::WriteInput("robot.yaml", data, size);
  fuzz::IsRead([&] {
    const Scenario scenario = ScenarioOfRobot(file, {}, fuzz::RequireWords);
    if (scenario.robot.model) FiguresOf(scenario.robot);
  });
  return 0;
}
