// SPDX-License-Identifier: BSD-3-Clause
#include "models/urdf_to_mjcf/mesh_file.h"

#include <algorithm>
#include <string_view>
#include <system_error>

namespace sidestep {
namespace {

constexpr std::string_view kPackage = "package://";

bool LiesIn(const std::filesystem::path& file, const std::filesystem::path& folder) {
  return std::mismatch(folder.begin(), folder.end(), file.begin(), file.end()).first ==
         folder.end();
}

/// What `filename` may mean within a folder.
std::vector<std::filesystem::path> WithinFolder(const std::string& filename) {
  if (!filename.starts_with(kPackage)) return {filename};
  const std::string rest = filename.substr(kPackage.size());
  const std::size_t slash = rest.find('/');
  if (slash == std::string::npos) return {};
  return {rest.substr(slash + 1), rest};
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
