// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// maker_point_biped: the URDF of a small biped whose legs have three joints and end in points.

#include <filesystem>
#include <string>

namespace sidestep {

/// What a leg of it ends in.
enum class PointFoot { kSphere, kDiscMesh, kFlatBox, kNone };

/// 1.6 kg, legs of 0.21 m and 0.21 m on hips 0.14 m apart: abduction, flexion, knee.
struct MakerPointBiped {
  std::string name{"points"};
  PointFoot foot{PointFoot::kDiscMesh};  ///< Discs of 18 mm radius across y; shins are meshes too.
};

/// The URDF's text; its meshes are meshes/disc.stl and meshes/shin.stl.
std::string UrdfOf(const MakerPointBiped& robot);

/// Writes `<name>.urdf` and its meshes into `folder`, which is made. Returns the URDF's path.
std::filesystem::path WriteMakerPointBiped(const MakerPointBiped& robot,
                                           const std::filesystem::path& folder);

}  // namespace sidestep
