// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// mjcf_complaint: what MuJoCo says of an MJCF that it can't compile, with its place and what to do.

#include <filesystem>
#include <string>

namespace sidestep {

/// Throws ConfigError: `file:line:column: error: ...`. MuJoCo tells a line, and none of what is
/// included; the place is that of the element of its words, the first such one where it tells no
/// line.
/// @param mjcf     Within CheckMjcfBounds().
/// @param message  As mj_loadXML() gives it.
[[noreturn]] void FailToCompile(const std::filesystem::path& mjcf, const std::string& message);

/// Throws ConfigError at the first mesh, height field, texture or skin of an MJCF that is read from
/// a file, if there is one: a model is compiled from its text alone.
void RefuseAssetFiles(const std::filesystem::path& mjcf);

}  // namespace sidestep
