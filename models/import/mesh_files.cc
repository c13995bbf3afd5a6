// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/mesh_files.h"

#include <algorithm>

#include "models/import/text.h"
#include "models/support/config_error.h"

namespace sidestep::importer {
namespace {

constexpr char kPackage[] = "package://";
constexpr char kFile[] = "file://";

std::filesystem::path RealFolder(const std::filesystem::path& folder) {
  std::error_code error;
  const std::filesystem::path real = std::filesystem::canonical(folder, error);
  if (error || !std::filesystem::is_directory(real)) {
    throw ConfigError("error: there is no folder " + folder.string());
  }
  return real;
}

/// Whether `file` lies in `folder`, both without links.
bool LiesIn(const std::filesystem::path& file, const std::filesystem::path& folder) {
  const auto [rest, unused] = std::mismatch(folder.begin(), folder.end(), file.begin(), file.end());
  return rest == folder.end();
}

}  // namespace

MeshFiles::MeshFiles(const std::filesystem::path& model, const Packages& packages)
    : folder_(RealFolder(std::filesystem::absolute(model).parent_path())) {
  for (const auto& [name, folder] : packages) packages_[name] = RealFolder(folder);
}

bool MeshFiles::IsAllowed(const std::filesystem::path& file) const {
  return LiesIn(file, folder_) ||
         std::any_of(packages_.begin(), packages_.end(),
                     [&](const auto& package) { return LiesIn(file, package.second); });
}

std::filesystem::path MeshFiles::FindFile(const std::string& uri, std::string* why) const {
  std::vector<std::filesystem::path> places;
  *why = "no such file in the model's folder";
  if (uri.rfind(kPackage, 0) == 0) {
    const std::string rest = uri.substr(sizeof(kPackage) - 1);
    const std::string package = rest.substr(0, rest.find('/'));
    const std::string below = rest.substr(std::min(package.size() + 1, rest.size()));
    const auto known = packages_.find(package);
    if (known != packages_.end()) {
      places = {known->second / below};
      *why = "no such file in the folder of package " + package;
    } else {
      places = {folder_ / below, folder_ / rest};
      *why = "name the folder of its package: --package " + package + "=FOLDER";
    }
  } else {
    places = {folder_ / (uri.rfind(kFile, 0) == 0 ? uri.substr(sizeof(kFile) - 1) : uri)};
  }
  for (const std::filesystem::path& place : places) {
    std::error_code error;
    const std::filesystem::path real = std::filesystem::weakly_canonical(place, error);
    if (error) continue;
    if (!IsAllowed(real)) {
      *why = "outside the model's folder; name the folder to read it: --package NAME=" +
             real.parent_path().string();
    } else if (std::filesystem::is_regular_file(real, error)) {
      return real;
    }
  }
  return {};
}

std::shared_ptr<const Mesh> MeshFiles::Find(const SourceShape& shape) {
  auto [known, is_new] = meshes_.try_emplace(shape.mesh);
  if (is_new) {
    std::string why;
    const std::filesystem::path file = FindFile(shape.mesh, &why);
    const std::optional<Mesh> mesh = file.empty() ? std::nullopt : LoadMesh(file, &why);
    if (mesh) {
      known->second = std::make_shared<const Mesh>(*mesh);
    } else {
      Complain(shape.mesh, why);
    }
  }
  if (!known->second || shape.scale == Eigen::Vector3d::Ones()) return known->second;
  return std::make_shared<const Mesh>(Scaled(*known->second, shape.scale));
}

void MeshFiles::Add(const std::string& uri, std::optional<Mesh> mesh) {
  meshes_[uri] = mesh ? std::make_shared<const Mesh>(*std::move(mesh)) : nullptr;
}

bool MeshFiles::IsMissing(const std::string& uri) const {
  const auto known = meshes_.find(uri);
  return known != meshes_.end() && !known->second;
}

void MeshFiles::Complain(const std::string& uri, const std::string& why) {
  meshes_[uri] = nullptr;
  complaints_[why].push_back(uri);
}

std::vector<std::string> MeshFiles::Complaints() const {
  std::vector<std::string> lines;
  for (const auto& [why, uris] : complaints_) {
    lines.push_back("could not read " + Listed(uris) + ": " + why);
  }
  return lines;
}

}  // namespace sidestep::importer
