// SPDX-License-Identifier: BSD-3-Clause
// A maker's URDF, as the importer reads it: up to its limbs and soles. The figures that it then
// looks for (start, gait, servos) take a second and more under sanitizers.

#include <string>

#include "models/import/body_plan.h"
#include "models/import/clean_up.h"
#include "models/import/feet.h"
#include "models/import/read_source.h"
#include "models/import/replace_meshes.h"
#include "models/import/write_urdf.h"
#include "tests/fuzz/fuzz_folder.h"
#include "tests/fuzz/fuzz_reader.h"

namespace sidestep::importer {
namespace {

void Read(const std::filesystem::path& urdf) {
  const std::string file = urdf.string();
  Notes notes;
  SourceRobot robot = ReadSource(urdf, &notes);
  Problems problems(file);
  CleanUp(&robot, &problems, &notes);
  problems.ThrowIfAny();
  MeshFiles meshes(urdf, {});
  const BodyPlan plan = FindBodyPlan(robot, file, &notes);
  MakeFeet(plan, file, &meshes, &robot, &notes);
  ReplaceCollisionMeshes(&meshes, &robot, &notes);
  UrdfText(robot, "maker.urdf");
}

}  // namespace
}  // namespace sidestep::importer

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace sidestep;
  const std::filesystem::path urdf = fuzz::WriteInput("maker.urdf", data, size);
  fuzz::IsRead([&] { importer::Read(urdf); });
  return 0;
}
