// SPDX-License-Identifier: BSD-3-Clause
#include "models/urdf_to_mjcf/mesh_file.h"

#include <algorithm>
#include <string_view>
#include <system_error>

namespace sidestep {
namespace {

constexpr std::string_view kScheme = "://";
constexpr std::size_t kMostFolders = 20;  // of a path

bool LiesIn(const std::filesystem::path& file, const std::filesystem::path& folder) {
  return std::mismatch(folder.begin(), folder.end(), file.begin(), file.end()).first ==
         folder.end();
}

/// What `filename` may mean within a folder: itself, then what is left of it without its scheme,
/// ups and first folders, the longest first.
std::vector<std::filesystem::path> WithinFolder(const std::string& filename) {
  const std::size_t scheme = filename.find(kScheme);
  const std::filesystem::path whole =
      scheme == std::string::npos ? filename : filename.substr(scheme + kScheme.size());
  std::vector<std::filesystem::path> names;
  for (const std::filesystem::path& name : whole.lexically_normal().relative_path()) {
    if (name == "..") continue;
    names.push_back(name);
  }
  std::vector<std::filesystem::path> places{whole};
  for (std::size_t first = 0; first < std::min(names.size(), kMostFolders); ++first) {
    std::filesystem::path place;
    for (std::size_t i = first; i < names.size(); ++i) place /= names[i];
    places.push_back(place);
  }
  return places;
}

}  // namespace

MeshFile FindMeshFile(const std::string& filename,
                      const std::vector<std::filesystem::path>& folders) {
  bool is_outside = false;
  for (const std::filesystem::path& folder : folders) {
    std::error_code error;
    const std::filesystem::path root = std::filesystem::canonical(folder, error);
    if (error) continue;
    for (const std::filesystem::path& place : WithinFolder(filename)) {
      const std::filesystem::path file = std::filesystem::weakly_canonical(root / place, error);
      if (error) continue;
      if (!LiesIn(file, root)) {
        is_outside = true;
      } else if (std::filesystem::is_regular_file(file, error)) {
        return {file, ""};
      }
    }
  }
  return {{}, is_outside ? "lies outside the robot's folder" : "is not in the robot's folder"};
}

}  // namespace sidestep
