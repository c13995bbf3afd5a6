// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// mjcf_includes: an MJCF of several files as one text, which compiles wherever it is.

#include <filesystem>
#include <string>

namespace sidestep {

/// `text` with the elements of other files in the places of its <include>s, as MuJoCo puts them; to
/// the byte where it has none. What MuJoCo refuses -- a file that is missing, is no XML or is there
/// twice, an <include> that holds something -- stays, for MuJoCo to tell.
/// @param text  Of `file`, within CheckMjcfBounds(). Throws ConfigError if it is not.
std::string WithIncluded(const std::string& text, const std::filesystem::path& file);

}  // namespace sidestep
