// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// xml_bounds: whether an XML text is small and flat enough for the parsers, which recurse over it.
//
// TinyXML, urdfdom and MuJoCo go down into elements by recursion, so that a hostile file ends them
// by the end of the stack. This looks at the text alone, in one pass.

#include <cstddef>
#include <filesystem>
#include <string>

namespace sidestep {

inline constexpr std::size_t kMaxXmlBytes = 64U << 20U;  ///< Public models have up to 10 MB.
inline constexpr int kMaxXmlDepth = 100;                 ///< Elements inside each other.
inline constexpr int kMaxXmlElements = 500'000;          ///< A link of a URDF takes about 20.

/// Throws ConfigError (`file:line:column: error: ...`) if `text` exceeds one of these bounds or is
/// nothing that XmlTags can scan. Says nothing more of whether it is good XML; where it is not, the
/// parser that follows may stop earlier but won't go deeper.
void CheckXmlBounds(const std::string& file, const std::string& text);

/// Text of a file within these bounds. Throws ConfigError if it is not, or can't be read.
std::string ReadXmlText(const std::filesystem::path& file);

/// `text` with a '?' for every byte that neither XML nor these parsers can take: NUL and other
/// control characters but tab, newline and carriage return, and bytes of no UTF-8 sequence. Places
/// stay as they are.
std::string WithoutStrayBytes(std::string text);

}  // namespace sidestep
