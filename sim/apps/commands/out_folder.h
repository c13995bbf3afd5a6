// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// out_folder: the folder that a run is left in, and what may be overwritten.

#include <filesystem>
#include <string>

namespace sidestep {

/// Throws ConfigError if PrepareOutFolder would; changes nothing.
void CheckOutFolder(const std::filesystem::path& folder, bool may_replace);

/// Makes `folder` an existing folder without a run in it.
///
/// A folder that is not empty is refused unless `may_replace`, and even then unless it is a run's
/// (it holds a scenario.yaml). Of a run only the files that a run writes are removed; whatever else
/// lies there stays.
/// @throws ConfigError if it is refused, is no folder, or can't be made.
void PrepareOutFolder(const std::filesystem::path& folder, bool may_replace);

/// Throws ConfigError unless `folder` is one that a run left (it holds a scenario.yaml).
void RequireRunFolder(const std::filesystem::path& folder);

/// Throws ConfigError unless a file may be written there: its folder exists, and it is no folder
/// itself and not there yet, or a file and `may_replace`.
void CheckOutFile(const std::filesystem::path& file, bool may_replace);

/// Writes a whole file, making the folder that it lies in. Throws ConfigError if it can't.
void WriteTextFile(const std::filesystem::path& file, const std::string& text);

}  // namespace sidestep
