// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// mjcf_bounds: whether an MJCF, with what it includes, is small and flat enough for MuJoCo.

#include <filesystem>

namespace sidestep {

/// Elements inside each other, files inside each other added up.
inline constexpr int kMaxMjcfDepth = 300;

/// Throws ConfigError if the file, or one that it includes, exceeds CheckXmlBounds(), or if all of
/// them together could nest deeper than kMaxMjcfDepth: MuJoCo recurses over elements. Files that
/// can't be read are left for MuJoCo to name.
void CheckMjcfBounds(const std::filesystem::path& mjcf);

}  // namespace sidestep
