// SPDX-License-Identifier: BSD-3-Clause
// A maker's URDF or MJCF, as the importer reads it: up to its limbs and soles. The figures that it
// then looks for (start, gait, servos) take a second and more under sanitizers. An export's own
// robot is taken out of it, and it is then read like anyone's.

#include <string>

#include "models/import/body_plan.h"
#include "models/import/clean_up.h"
#include "models/import/embedded_robot.h"
#include "models/import/feet.h"
#include "models/import/mjcf_couplings.h"
#include "models/import/read_mjcf.h"
#include "models/import/read_source.h"
#include "models/import/replace_meshes.h"
#include "models/import/write_urdf.h"
#include "models/support/xml_bounds.h"
#include "tests/fuzz/fuzz_folder.h"
#include "tests/fuzz/fuzz_reader.h"

namespace sidestep::importer {
namespace {

SourceRobot ReadAny(const std::filesystem::path& source, MeshFiles* meshes, Notes* notes) {
  if (!IsMjcf(source)) return ReadSource(source, notes);
  RobotFilesIn(ReadXmlText(source));
  return ReadMjcf(source, meshes, notes);
}

void Read(const std::filesystem::path& source) {
  const std::string file = source.string();
  Notes notes;
  MeshFiles meshes(source, {});
  SourceRobot robot = ReadAny(source, &meshes, &notes);
  Problems problems(file);
  CleanUp(&robot, &problems, &notes);
  problems.ThrowIfAny();
  const BodyPlan plan = FindBodyPlan(robot, file, &notes);
  RefuseCouplings(robot.couplings, plan.Actuated());
  MakeFeet(plan, file, &meshes, &robot, &notes);
  ReplaceCollisionMeshes(&meshes, &robot, &notes);
  UrdfText(robot, "maker.urdf");
}

}  // namespace
}  // namespace sidestep::importer

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace sidestep;
  const std::filesystem::path source = fuzz::WriteInput("maker.urdf", data, size);
  fuzz::IsRead([&] { importer::Read(source); });
  return 0;
}
