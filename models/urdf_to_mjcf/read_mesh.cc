// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>
#include <string_view>
#include <system_error>

#include "models/mjcf/mjcf.h"
#include "models/support/parse_number.h"
#include "models/urdf_to_mjcf/mesh_file.h"

namespace sidestep {
namespace {

constexpr std::uintmax_t kMaxBytes = 64U << 20U;
constexpr std::size_t kStlHeader = 84, kStlFacet = 50;  // bytes
constexpr std::size_t kCornerOffset = 12;               // of a facet, behind its normal
constexpr float kMaxCoordinate = 1e6F;                  // catches what is no number of any unit
constexpr double kFlatness = 1e-5;                      // least extent over greatest

using Corners = std::vector<Eigen::Vector3f>;

/// Words of a text, one after the other.
class Words {
 public:
  explicit Words(std::string_view text) : text_(text) {}

  /// The next word, empty at the end.
  std::string_view Next() {
    const std::size_t start = std::min(text_.find_first_not_of(kBlanks), text_.size());
    text_.remove_prefix(start);
    const std::size_t length = std::min(text_.find_first_of(kBlanks), text_.size());
    const std::string_view word = text_.substr(0, length);
    text_.remove_prefix(length);
    return word;
  }

  /// Three numbers; NaN for what is none.
  Eigen::Vector3f NextVector() {
    Eigen::Vector3f vector;
    for (float& entry : vector) {
      std::string_view word = Next();
      if (word.starts_with('+')) word.remove_prefix(1);
      entry = ParseAs<float>(word).value_or(std::numeric_limits<float>::quiet_NaN());
    }
    return vector;
  }

 private:
  static constexpr std::string_view kBlanks = " \t\r\n";
  std::string_view text_;
};

bool IsTooMuch(const Corners& triangles) { return triangles.size() > 3 * kMaxTriangles; }

bool ReadBinaryStl(const std::string& bytes, Corners* triangles) {
  if (bytes.size() < kStlHeader) return false;
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + kStlHeader - sizeof(count), sizeof(count));
  if (bytes.size() != kStlHeader + kStlFacet * count) return false;
  triangles->resize(std::size_t{3} * count);
  for (std::size_t i = 0; i < triangles->size(); ++i) {
    const std::size_t at =
        kStlHeader + kStlFacet * (i / 3) + kCornerOffset + sizeof(Eigen::Vector3f) * (i % 3);
    std::memcpy((*triangles)[i].data(), bytes.data() + at, sizeof(Eigen::Vector3f));
  }
  return true;
}

bool ReadAsciiStl(std::string_view text, Corners* triangles) {
  Words words(text);
  if (words.Next() != "solid") return false;
  for (std::string_view word = words.Next(); !word.empty(); word = words.Next()) {
    if (IsTooMuch(*triangles)) return true;
    if (word == "vertex") triangles->push_back(words.NextVector());
  }
  return !triangles->empty() && triangles->size() % 3 == 0;
}

/// Index of "7", "7/1", "7/1/2", "7//2" or "-1" (the last so far) in `count` vertices.
std::optional<std::size_t> ObjIndex(std::string_view word, std::size_t count) {
  const auto number = ParseAs<std::int64_t>(word.substr(0, word.find('/')));
  if (!number) return std::nullopt;
  const auto size = static_cast<std::int64_t>(count);
  const std::int64_t index = *number > 0 ? *number - 1 : size + *number;
  if (*number == 0 || index < 0 || index >= size) return std::nullopt;
  return static_cast<std::size_t>(index);
}

bool ReadObj(std::string_view text, Corners* triangles) {
  std::vector<Eigen::Vector3f> vertices;
  while (!text.empty() && !IsTooMuch(*triangles)) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    Words words(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    const std::string_view kind = words.Next();
    if (kind == "v") vertices.push_back(words.NextVector());
    if (kind != "f") continue;
    std::vector<Eigen::Vector3f> face;
    for (std::string_view word = words.Next(); !word.empty(); word = words.Next()) {
      const auto index = ObjIndex(word, vertices.size());
      if (!index) return false;
      face.push_back(vertices[*index]);
    }
    for (std::size_t i = 2; i < face.size(); ++i) {
      if (IsTooMuch(*triangles)) break;
      triangles->insert(triangles->end(), {face[0], face[i - 1], face[i]});
    }
  }
  return true;
}

/// Whether all corners lie in a plane, on a line or at a point.
bool IsFlat(const Corners& triangles) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3f& corner : triangles) mean += corner.cast<double>();
  mean /= static_cast<double>(triangles.size());
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3f& corner : triangles) {
    const Eigen::Vector3d arm = corner.cast<double>() - mean;
    covariance += arm * arm.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance, Eigen::EigenvaluesOnly);
  const Eigen::Vector3d& spread = solver.eigenvalues();  // ascending
  return !(spread(0) > kFlatness * kFlatness * spread(2));
}

bool IsReasonable(const Eigen::Vector3f& corner) {
  return corner.allFinite() && corner.cwiseAbs().maxCoeff() < kMaxCoordinate;
}

}  // namespace

std::string ReadMesh(const std::filesystem::path& file, Triangles* triangles) {
  *triangles = {};
  Corners& corners = triangles->corners;
  std::string format = file.extension().string();
  std::transform(format.begin(), format.end(), format.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (format != ".stl" && format != ".obj") return "is neither STL nor OBJ";
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  if (error || size > kMaxBytes) return "is longer than 64 MiB";
  if (size == 0) return "is empty";
  const std::string bytes = ReadTextFile(file);
  triangles->is_binary_stl = format == ".stl" && ReadBinaryStl(bytes, &corners);
  if (!triangles->is_binary_stl) {
    const bool is_read =
        format == ".obj" ? ReadObj(bytes, &corners) : ReadAsciiStl(bytes, &corners);
    if (!is_read) return "is torn, or not in its format";
  }
  if (corners.empty()) return "has no triangles";
  if (IsTooMuch(corners)) {
    return "has more than " + std::to_string(kMaxTriangles) + " triangles";
  }
  if (!std::all_of(corners.begin(), corners.end(), IsReasonable)) {
    return "has corners that are not finite, or farther away than a million";
  }
  return IsFlat(corners) ? "is flat" : "";
}

}  // namespace sidestep
