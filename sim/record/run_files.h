// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// run_files: which files of a run's folder are the program's own, so that nothing else is ever
// replaced or removed.
//
// The list is `run_files.txt` in the folder: a head line, then a path a line, relative to the
// folder. Whoever writes a file there lists it first.

#include <filesystem>
#include <string>
#include <vector>

namespace sidestep {

inline constexpr const char* kRunFilesName = "run_files.txt";

/// Adds to the list of `run_dir` what is not on it yet; begins a list if there is none.
/// @param names  Relative paths, `plots/com.svg`.
/// @throws ConfigError if the list can't be written.
void ListRunFiles(const std::filesystem::path& run_dir, const std::vector<std::string>& names);

/// Lists `file` if it lies in `run_dir` itself, however either is spelled. Throws as
/// ListRunFiles().
void ListIfInRun(const std::filesystem::path& run_dir, const std::filesystem::path& file);

/// What the list of `run_dir` names; empty if there is none. A name that could lead out of the
/// folder (absolute, `..`) is left out: the list may be anybody's.
std::vector<std::string> ListedRunFiles(const std::filesystem::path& run_dir);

/// Removes the listed files of `run_dir`, then folders that this leaves empty, then the list. Only
/// plain files go, and none through a link.
void RemoveListedRunFiles(const std::filesystem::path& run_dir);

}  // namespace sidestep
