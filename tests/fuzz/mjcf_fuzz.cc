// SPDX-License-Identifier: BSD-3-Clause
// An MJCF, as MuJoCo compiles it behind our bounds.

#include "models/mjcf/mjcf.h"
#include "models/robot_description/mjcf_names.h"
#include "models/robot_description/robot_model.h"
#include "tests/fuzz/fuzz_folder.h"
#include "tests/fuzz/fuzz_reader.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace sidestep;
  const std::filesystem::path file = fuzz::WriteInput("robot.xml", data, size);
  fuzz::IsRead([&] {
    ReadMjcfNames(file);
    CompileMjcf(ReadMjcfModel(file).simulated_mjcf, "", file);
  });
  return 0;
}
