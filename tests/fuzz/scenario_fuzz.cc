// SPDX-License-Identifier: BSD-3-Clause
// A scenario's file. One that is read is read again from what is written of it, as the same.

#include <map>
#include <string>

#include "sim/scenario/read_scenario.h"
#include "sim/scenario/write_scenario.h"
#include "tests/fuzz/fuzz_folder.h"
#include "tests/fuzz/fuzz_reader.h"

namespace sidestep::fuzz {
namespace {

// Robots that ship are read once: robot_fuzz has their reader.
RobotDescription KnownRobot(const std::filesystem::path& file) {
  static std::map<std::filesystem::path, RobotDescription> known;
  const auto found = known.find(file);
  return found != known.end() ? found->second
                              : known.emplace(file, ReadSoundRobot(file)).first->second;
}

Scenario Read(const std::filesystem::path& file) {
  return ReadScenario(file, {}, RequireWords, KnownRobot);
}

}  // namespace
}  // namespace sidestep::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace sidestep;
  const std::filesystem::path file = fuzz::WriteInput("scenario.yaml", data, size);
  Scenario scenario;
  if (!fuzz::IsRead([&] { scenario = fuzz::Read(file); })) return 0;
  const std::string resolved = ResolvedYaml(scenario);
  const std::filesystem::path again = fuzz::InputFolder().Write("resolved.yaml", resolved);
  fuzz::RequireRead([&] {
    fuzz::Require(ResolvedYaml(fuzz::Read(again)) == resolved, "reads back as another scenario");
  });
  return 0;
}
