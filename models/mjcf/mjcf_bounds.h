// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// mjcf_bounds: whether an MJCF, with what it includes, is small and flat enough for MuJoCo.

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>

#include "models/support/xml_tags.h"

namespace sidestep {

/// Elements inside each other, files inside each other added up.
inline constexpr int kMaxMjcfDepth = 300;

/// Elements of all files together. Public robots have a thousand; MuJoCo takes seconds for ten
/// thousand and, with the square of them, minutes for more.
inline constexpr std::ptrdiff_t kMaxMjcfElements = 5000;

/// Where MuJoCo looks for what `mjcf` includes, or what is included by what it includes: `name`
/// behind the folder of `mjcf`, even where it begins with a '/'.
std::filesystem::path IncludedFile(const std::filesystem::path& mjcf, const std::string& name);

/// Is told of a tag, and of which file it is.
using TagVisitor = std::function<void(const XmlTags& tags, const XmlTag& tag)>;

/// Visits all tags of an MJCF and, in their <include>s' places, of the files that it includes.
/// Throws ConfigError (`file:line:column: error: ...`) if one of the files exceeds CheckXmlBounds()
/// or MjcfSizes, or if all of them together nest deeper than kMaxMjcfDepth, over which MuJoCo
/// recurses, have more than kMaxMjcfElements or are longer than kMaxXmlBytes. A file counts as
/// often as it is included. Files that are missing are left for MuJoCo to name.
void VisitMjcf(const std::filesystem::path& mjcf, const TagVisitor& visit);

/// Throws as VisitMjcf() does.
void CheckMjcfBounds(const std::filesystem::path& mjcf);

}  // namespace sidestep
