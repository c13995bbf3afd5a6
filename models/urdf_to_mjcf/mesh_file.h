// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// mesh_file: triangles to look at, from STL and OBJ files within a robot's folder.

#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <vector>

namespace sidestep {

/// MuJoCo takes no more of one mesh.
inline constexpr std::size_t kMaxTriangles = 200'000;

/// A file, or why there is none that may be read ("is not there").
struct MeshFile {
  std::filesystem::path path;  ///< Without symbolic links.
  std::string fault;
};

/// The file that a URDF calls `filename`: a path relative to one of `folders` or, of
/// `package://name/path`, `name/path` there. Where that is none, first folders (and `..`) of the
/// path are let go one by one, as robots are moved without their packages. Whatever it says, and
/// wherever symbolic links lead, a file outside the folders is none.
MeshFile FindMeshFile(const std::string& filename,
                      const std::vector<std::filesystem::path>& folders);

/// Three corners a triangle, in the file's own unit and axes.
struct Triangles {
  std::vector<Eigen::Vector3f> corners;
  bool is_binary_stl{false};  ///< The file is one: MuJoCo reads it as well as we do.
};

/// Reads a .stl, binary or ASCII, or an .obj with all that is in it. Returns why it can't be drawn,
/// empty if it can: another format, torn, not finite, none or more than kMaxTriangles triangles,
/// flat (MuJoCo gives every mesh a volume).
std::string ReadMesh(const std::filesystem::path& file, Triangles* triangles);

}  // namespace sidestep
