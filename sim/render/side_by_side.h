// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// side_by_side: two runs drawn anew beside each other, at the same time.

#include <array>
#include <filesystem>

#include "sim/render/render_options.h"

namespace sidestep {

/// Draws the same part of both runs, left and right, as options say, each under its name, its
/// step adjustment if that is what differs, and its outcome. Neither needs a video. The run that is
/// over first shows its last frame until the other one is over, too; from the start if it was over
/// before options.from_s.
/// @param film  An MP4, or a GIF if it is called so; on the first run's list if it is in its
/// folder.
/// @throws ConfigError as RenderRun, and if neither run has that part; the file appears whole or
/// not at all.
void RenderSideBySide(const std::array<std::filesystem::path, 2>& run_dirs,
                      const RenderOptions& options, const std::filesystem::path& film);

}  // namespace sidestep
