// SPDX-License-Identifier: BSD-3-Clause
// A URDF: read, converted and compiled with motors on all that moves.

#include <algorithm>
#include <string>

#include "models/mjcf/mjcf.h"
#include "models/urdf_to_mjcf/read_urdf.h"
#include "models/urdf_to_mjcf/urdf_to_mjcf.h"
#include "tests/fuzz/fuzz_folder.h"
#include "tests/fuzz/fuzz_reader.h"

namespace sidestep::fuzz {
namespace {

UrdfConversion ConversionOf(const UrdfParts& parts) {
  UrdfConversion conversion;
  for (const UrdfJointInfo& joint : parts.joints) {
    if (joint.fault.empty()) {
      conversion.actuators.push_back(
          {joint.name, std::clamp(joint.effort_Nm, 1.0, 1e4), 0.01, 0.1});
    } else {
      conversion.locked_joints.push_back(joint.name);
    }
  }
  for (const UrdfFrameInfo& frame : parts.frames) {
    conversion.imu = frame.name;
    conversion.foot_frames = {frame.name};
  }
  return conversion;
}

}  // namespace
}  // namespace sidestep::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace sidestep;
  const std::filesystem::path file = fuzz::WriteInput("robot.urdf", data, size);
  fuzz::IsRead([&] {
    const UrdfParts parts = ReadUrdfParts(file);
    if (parts.frames.empty()) return;  // no IMU: a robot.yaml can't name one
    const UrdfMjcf mjcf = UrdfToMjcf(file, fuzz::ConversionOf(parts));
    CompileMjcf(mjcf.robot, "", file);
  });
  return 0;
}
