// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// mesh_files: where the meshes of a URDF or an MJCF are, and their triangles, each read once.

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "models/import/mesh.h"
#include "models/import/source_robot.h"

namespace sidestep::importer {

/// package:// paths: the package's name and the folder that stands for it.
using Packages = std::map<std::string, std::filesystem::path>;

/// Reads files of the model's own folder and of the packages' folders, and no others: neither by
/// `..`, nor by a link, nor by a path from the root.
class MeshFiles {
 public:
  MeshFiles(const std::filesystem::path& model, const Packages& packages);

  /// The triangles of a shape that is a mesh, scaled, in the shape's frame; null if there are none.
  std::shared_ptr<const Mesh> Find(const SourceShape& shape);

  /// The real path of a file that may be read; empty, with the reason, if there is none.
  std::filesystem::path FindFile(const std::string& uri, std::string* why) const;

  /// Triangles that are known already, for shapes whose mesh is called `uri`; or that it has none.
  void Add(const std::string& uri, std::optional<Mesh> mesh);

  /// Whether it is known that a mesh of this name can't be had.
  bool IsMissing(const std::string& uri) const;

  /// That a mesh of this name could not be read, and why.
  void Complain(const std::string& uri, const std::string& why);

  /// What could not be read, and why: one sentence a reason.
  std::vector<std::string> Complaints() const;

 private:
  bool IsAllowed(const std::filesystem::path& file) const;

  std::filesystem::path folder_;
  Packages packages_;
  std::map<std::string, std::shared_ptr<const Mesh>> meshes_;   ///< By uri, as in the file.
  std::map<std::string, std::vector<std::string>> complaints_;  ///< Uris, by reason.
};

}  // namespace sidestep::importer
