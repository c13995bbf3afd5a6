// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// stl_text: meshes for tests, as the bytes of a binary STL.

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace sidestep {

/// Three corners a triangle; edges of 0.1.
inline const std::vector<Eigen::Vector3f>& Tetrahedron() {
  static const std::vector<Eigen::Vector3f> corners = [] {
    const Eigen::Vector3f o(0, 0, 0), x(0.1F, 0, 0), y(0, 0.1F, 0), z(0, 0, 0.1F);
    return std::vector<Eigen::Vector3f>{o, y, x, o, x, z, o, z, y, x, y, z};
  }();
  return corners;
}

/// A binary STL of triangles with these corners; its normals are zero.
inline std::string StlText(const std::vector<Eigen::Vector3f>& corners) {
  std::string text(80, '\0');
  const auto append = [&](const auto& value) {
    std::array<char, sizeof(value)> bytes{};
    std::memcpy(bytes.data(), &value, sizeof(value));
    text.append(bytes.data(), bytes.size());
  };
  append(static_cast<std::uint32_t>(corners.size() / 3));
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (i % 3 == 0) text.append(3 * sizeof(float), '\0');
    for (const float coordinate : corners[i]) append(coordinate);
    if (i % 3 == 2) append(std::uint16_t{0});
  }
  return text;
}

}  // namespace sidestep
