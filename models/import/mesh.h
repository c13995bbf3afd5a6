// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// mesh: triangles of a mesh file, with fewer of them, and as STL. The only place that knows assimp
// and meshoptimizer.

#include <Eigen/Core>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace sidestep::importer {

struct Mesh {
  std::vector<Eigen::Vector3f> vertices;  ///< m.
  std::vector<unsigned> corners;          ///< Indices of vertices, three a triangle.

  std::size_t num_triangles() const { return corners.size() / 3; }
};

/// Reads STL, OBJ, DAE and what else assimp reads, as they are: no axes are swapped. Opens no other
/// file, whatever the mesh refers to. Empty, with the reason in `why`, if it can't be read, has no
/// triangle or is larger than 200 MB.
std::optional<Mesh> LoadMesh(const std::filesystem::path& file, std::string* why);

/// Scaled; a mirrored mesh keeps its triangles' outsides outside.
Mesh Scaled(Mesh mesh, const Eigen::Vector3d& scale);

/// At most about `most` triangles; vertices at the same place become one.
Mesh Decimated(const Mesh& mesh, std::size_t most);

/// Binary STL. Throws ConfigError if it can't be written.
void WriteStl(const Mesh& mesh, const std::filesystem::path& file);

}  // namespace sidestep::importer
