// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/replace_meshes.h"

#include <algorithm>
#include <map>
#include <set>

#include "models/import/fit_shapes.h"
#include "models/import/text.h"
#include "models/support/config_error.h"
#include "models/support/plain_word.h"

namespace sidestep::importer {
namespace {

constexpr std::size_t kMostTriangles = 60'000;     // of a whole robot: see the film's time a frame
constexpr std::size_t kMostTrianglesEach = 4'000;  // of one mesh
constexpr std::size_t kLeastTrianglesEach = 200;
constexpr double kClearance_m = 0.005;  // over the ground

/// Lowest point of a shape posed by X_WL.
double LowestPoint(const SourceShape& shape, const Eigen::Isometry3d& X_WL) {
  double lowest = 1e300;
  for (const Eigen::Vector3d& p : SurfaceOf(shape, nullptr)) {
    const double radius_m = shape.kind == ShapeKind::kSphere ? shape.size_m.x() : 0.0;
    lowest = std::min(lowest, (X_WL * p).z() - radius_m);
  }
  return lowest;
}

/// `name` without what does not belong in a file's name.
std::string FileWord(const std::string& name) {
  const std::string word = PlainCharactersOf(name);
  return IsPlainWord(word) ? word : "mesh_" + word.substr(0, kMaxWordLength / 2);
}

std::size_t CountMeshes(const SourceRobot& robot) {
  std::size_t count = 0;
  for (const SourceLink& link : robot.links) {
    for (const SourceShape& shape : link.visuals) count += shape.kind == ShapeKind::kMesh ? 1 : 0;
  }
  return count;
}

}  // namespace

void ReplaceCollisionMeshes(MeshFiles* meshes, SourceRobot* robot, Notes* notes) {
  std::vector<std::string> fitted, from_inertia, dropped, empty;
  for (SourceLink& link : robot->links) {
    std::erase_if(link.visuals, IsEmpty);
    if (std::erase_if(link.collisions, IsEmpty) > 0) empty.push_back(link.name);
    std::vector<SourceShape> kept;
    bool has_box = false;
    for (const SourceShape& shape : link.collisions) {
      if (shape.kind != ShapeKind::kMesh) {
        kept.push_back(shape);
        continue;
      }
      const std::shared_ptr<const Mesh> mesh = meshes->Find(shape);
      if (mesh) {
        kept.push_back(FitShape(SurfaceOf(shape, mesh.get())));
        kept.back().note = "fitted to " + shape.mesh;
        if (fitted.empty() || fitted.back() != link.name) fitted.push_back(link.name);
      } else if (link.has_mass() && !has_box) {
        kept.push_back(BoxOfInertia(link.mass));
        kept.back().note = "the box of the link's inertia: " + shape.mesh + " could not be read";
        from_inertia.push_back(link.name);
        has_box = true;
      } else if (!link.has_mass()) {
        dropped.push_back(link.name);
      }
    }
    link.collisions = std::move(kept);
  }
  if (!fitted.empty())
    notes->push_back("fitted boxes and capsules to the meshes of " + Listed(fitted));
  if (!from_inertia.empty()) {
    notes->push_back("took boxes of their inertia for the shapes of " + Listed(from_inertia));
  }
  if (!empty.empty()) {
    notes->push_back("left out collision shapes of " + Listed(empty) + ", which have no volume");
  }
  if (!dropped.empty()) notes->push_back("left out the collision meshes of " + Listed(dropped));
}

void DropShapesInTheGround(const Posture& start, const std::vector<int>& feet, SourceRobot* robot,
                           Notes* notes) {
  std::set<int> of_feet;
  for (const int foot : feet) {
    for (const int link : Subtree(*robot, foot)) of_feet.insert(link);
  }
  const Placement placement(*robot, start);
  std::vector<std::string> dropped;
  for (const int index : robot->order) {
    SourceLink& link = robot->links[static_cast<std::size_t>(index)];
    if (of_feet.count(index) > 0) continue;
    const auto is_low = [&](const SourceShape& shape) {
      return LowestPoint(shape, placement.X_WL(index)) < kClearance_m;
    };
    if (std::erase_if(link.collisions, is_low) > 0) dropped.push_back(link.name);
  }
  if (!dropped.empty()) {
    notes->push_back("left out collision shapes of " + Listed(dropped) +
                     ", which touch the ground beside the soles");
  }
}

void WriteVisualMeshes(const std::filesystem::path& folder, bool is_wanted, MeshFiles* meshes,
                       SourceRobot* robot, Notes* notes) {
  const std::size_t most =
      std::clamp(kMostTriangles / std::max<std::size_t>(1, CountMeshes(*robot)),
                 kLeastTrianglesEach, kMostTrianglesEach);
  std::map<std::string, int> used;
  std::size_t files = 0, triangles = 0;
  for (SourceLink& link : robot->links) {
    std::vector<SourceShape> kept;
    for (SourceShape& shape : link.visuals) {
      if (shape.kind != ShapeKind::kMesh) kept.push_back(shape);
      const std::shared_ptr<const Mesh> mesh =
          shape.kind == ShapeKind::kMesh && is_wanted ? meshes->Find(shape) : nullptr;
      if (!mesh) continue;
      const Mesh small = Decimated(*mesh, most);
      if (small.corners.empty()) continue;
      const std::string word = FileWord(link.name);
      const int count = ++used[word];
      shape.mesh = "meshes/" + word + (count > 1 ? "_" + std::to_string(count) : "") + ".stl";
      shape.scale.setOnes();
      std::filesystem::create_directories(folder / "meshes");
      WriteStl(small, folder / shape.mesh);
      ++files;
      triangles += small.num_triangles();
      kept.push_back(shape);
    }
    link.visuals = std::move(kept);
  }
  if (files > 0) {
    notes->push_back("wrote " + std::to_string(files) + " meshes to draw, of " +
                     std::to_string(triangles) + " triangles");
  }
}

}  // namespace sidestep::importer
