// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/mesh.h"

#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <meshoptimizer.h>

#include <Eigen/Geometry>
#include <array>
#include <assimp/IOSystem.hpp>
#include <assimp/Importer.hpp>
#include <cstdint>
#include <cstring>
#include <utility>

#include "models/import/write_file.h"
#include "models/mjcf/mjcf.h"

namespace sidestep::importer {
namespace {

constexpr std::uintmax_t kMaxBytes = 200'000'000;
constexpr float kDecimationError = 0.05F;  // of the mesh's size: the number of triangles decides

/// No file is there but the one in memory.
class NoFiles final : public Assimp::IOSystem {
 public:
  bool Exists(const char* /*file*/) const override { return false; }
  char getOsSeparator() const override { return '/'; }
  Assimp::IOStream* Open(const char* /*file*/, const char* /*mode*/) override { return nullptr; }
  void Close(Assimp::IOStream* /*file*/) override {}
};

/// All meshes that hang on the scene's nodes, in the scene's frame.
Mesh Collect(const aiScene& scene) {
  Mesh mesh;
  std::vector<std::pair<const aiNode*, aiMatrix4x4>> nodes{{scene.mRootNode, aiMatrix4x4()}};
  while (!nodes.empty()) {
    const auto [node, above] = nodes.back();
    nodes.pop_back();
    const aiMatrix4x4 here = above * node->mTransformation;
    for (unsigned i = 0; i < node->mNumChildren; ++i) nodes.emplace_back(node->mChildren[i], here);
    for (unsigned i = 0; i < node->mNumMeshes; ++i) {
      const aiMesh& part = *scene.mMeshes[node->mMeshes[i]];
      const auto first = static_cast<unsigned>(mesh.vertices.size());
      for (unsigned v = 0; v < part.mNumVertices; ++v) {
        const aiVector3D p = here * part.mVertices[v];
        mesh.vertices.emplace_back(p.x, p.y, p.z);
      }
      for (unsigned f = 0; f < part.mNumFaces; ++f) {
        if (part.mFaces[f].mNumIndices != 3) continue;
        for (unsigned c = 0; c < 3; ++c) mesh.corners.push_back(first + part.mFaces[f].mIndices[c]);
      }
    }
  }
  return mesh;
}

bool IsFinite(const Mesh& mesh) {
  for (const Eigen::Vector3f& vertex : mesh.vertices) {
    if (!vertex.allFinite()) return false;
  }
  return true;
}

}  // namespace

std::optional<Mesh> LoadMesh(const std::filesystem::path& file, std::string* why) {
  std::error_code error;
  const std::uintmax_t bytes = std::filesystem::file_size(file, error);
  *why = error               ? "can't be read"
         : bytes == 0        ? "is empty"
         : bytes > kMaxBytes ? "is larger than 200 MB"
                             : "";
  if (!why->empty()) return std::nullopt;
  const std::string content = ReadTextFile(file);
  if (content.rfind("version https://git-lfs", 0) == 0) {
    *why = "is only a pointer of Git LFS; fetch the file itself";
    return std::nullopt;
  }
  Assimp::Importer importer;
  importer.SetIOHandler(new NoFiles);  // the importer deletes it
  importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, true);
  const std::string hint = file.extension().string();
  const aiScene* scene = importer.ReadFileFromMemory(
      content.data(), content.size(), aiProcess_Triangulate, hint.empty() ? "" : hint.c_str() + 1);
  if (scene == nullptr || scene->mRootNode == nullptr) {
    *why = std::string("can't be read: ") + importer.GetErrorString();
    return std::nullopt;
  }
  Mesh mesh = Collect(*scene);
  if (mesh.corners.empty() || !IsFinite(mesh)) {
    *why = "has no triangles of finite numbers";
    return std::nullopt;
  }
  return Decimated(mesh, mesh.num_triangles());  // STL repeats every vertex
}

Mesh Scaled(Mesh mesh, const Eigen::Vector3d& scale) {
  for (Eigen::Vector3f& vertex : mesh.vertices) vertex = vertex.cwiseProduct(scale.cast<float>());
  if (scale.prod() < 0.0) {
    for (std::size_t i = 0; i + 2 < mesh.corners.size(); i += 3) {
      std::swap(mesh.corners[i], mesh.corners[i + 1]);
    }
  }
  return mesh;
}

Mesh Decimated(const Mesh& mesh, std::size_t most) {
  const std::size_t count = mesh.vertices.size();
  std::vector<unsigned> remap(count);
  const std::size_t unique =
      meshopt_generateVertexRemap(remap.data(), mesh.corners.data(), mesh.corners.size(),
                                  mesh.vertices.data(), count, sizeof(Eigen::Vector3f));
  Mesh small;
  small.vertices.resize(unique);
  small.corners.resize(mesh.corners.size());
  meshopt_remapVertexBuffer(small.vertices.data(), mesh.vertices.data(), count,
                            sizeof(Eigen::Vector3f), remap.data());
  meshopt_remapIndexBuffer(small.corners.data(), mesh.corners.data(), mesh.corners.size(),
                           remap.data());
  if (small.num_triangles() <= most) return small;
  const std::vector<unsigned> corners = small.corners;
  const auto simplify = [&](auto&& how) {
    small.corners.resize(corners.size());
    small.corners.resize(how());
  };
  simplify([&] {
    return meshopt_simplify(small.corners.data(), corners.data(), corners.size(),
                            small.vertices[0].data(), unique, sizeof(Eigen::Vector3f), 3 * most,
                            kDecimationError, 0, nullptr);
  });
  if (small.num_triangles() <= most + most / 2) return small;
  simplify([&] {  // where edges that are no one's neighbours hold the first up
    return meshopt_simplifySloppy(small.corners.data(), corners.data(), corners.size(),
                                  small.vertices[0].data(), unique, sizeof(Eigen::Vector3f),
                                  3 * most, 1.0F, nullptr);
  });
  return small;
}

void WriteStl(const Mesh& mesh, const std::filesystem::path& file) {
  std::string text(80, '\0');  // a header that nobody reads
  const auto append = [&](const auto& value) {
    std::array<char, sizeof(value)> bytes{};
    std::memcpy(bytes.data(), &value, sizeof(value));
    text.append(bytes.data(), bytes.size());
  };
  append(static_cast<std::uint32_t>(mesh.num_triangles()));
  for (std::size_t i = 0; i + 2 < mesh.corners.size(); i += 3) {
    std::array<Eigen::Vector3f, 4> rows;  // normal, corners
    for (std::size_t c = 0; c < 3; ++c) rows[c + 1] = mesh.vertices[mesh.corners[i + c]];
    rows[0] = (rows[2] - rows[1]).cross(rows[3] - rows[1]).stableNormalized();
    for (const Eigen::Vector3f& row : rows) {
      for (Eigen::Index k = 0; k < 3; ++k) append(row[k]);
    }
    append(std::uint16_t{0});
  }
  WriteFile(file, text);
}

}  // namespace sidestep::importer
