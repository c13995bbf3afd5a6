// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// mjcf_bounds: whether an MJCF, with what it includes, is small and flat enough for MuJoCo.

#include <cstddef>
#include <filesystem>
#include <string>

namespace sidestep {

/// Elements inside each other, files inside each other added up.
inline constexpr int kMaxMjcfDepth = 300;

/// Elements of all files together. Public robots have a thousand; MuJoCo takes seconds for ten
/// thousand and, with the square of them, minutes for more.
inline constexpr std::ptrdiff_t kMaxMjcfElements = 5000;

/// Where MuJoCo looks for what `mjcf` includes, or what is included by what it includes: `name`
/// behind the folder of `mjcf`, even where it begins with a '/'.
std::filesystem::path IncludedFile(const std::filesystem::path& mjcf, const std::string& name);

/// Throws ConfigError (`file:line:column: error: ...`) if the file, or one that it includes,
/// exceeds CheckXmlBounds() or MjcfSizes, or if all of them together nest deeper than
/// kMaxMjcfDepth, over which MuJoCo recurses, have more than kMaxMjcfElements or are longer than
/// kMaxXmlBytes. A file counts as often as it is included. Files that are missing are left for
/// MuJoCo to name.
void CheckMjcfBounds(const std::filesystem::path& mjcf);

}  // namespace sidestep
