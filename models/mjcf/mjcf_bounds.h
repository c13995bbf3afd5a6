// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// mjcf_bounds: whether an MJCF, with what it includes, is small and flat enough for MuJoCo.

#include <cstddef>
#include <filesystem>

namespace sidestep {

/// Elements inside each other, files inside each other added up.
inline constexpr int kMaxMjcfDepth = 300;

/// Elements of all files together. Public robots have a thousand; MuJoCo takes seconds for ten
/// thousand and, with the square of them, minutes for more.
inline constexpr std::ptrdiff_t kMaxMjcfElements = 5000;

/// Throws ConfigError if the file, or one that it includes, exceeds CheckXmlBounds() or
/// CheckMjcfSizes(), or if all of them together could nest deeper than kMaxMjcfDepth, over which
/// MuJoCo recurses, or have more than kMaxMjcfElements. Files that can't be read are left for
/// MuJoCo to name.
void CheckMjcfBounds(const std::filesystem::path& mjcf);

}  // namespace sidestep
