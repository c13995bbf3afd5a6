// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// include_rules: the engine of the layering test. It reads no file but what ReadSources is given,
// so that the rules themselves can be tested on made-up sources.

#include <filesystem>
#include <string>
#include <vector>

namespace sidestep::layering {

/// A room of the house: one folder of sources, without its subfolders.
struct Room {
  std::string folder;                    ///< From the root, such as "controller/wbc".
  std::vector<std::string> may_include;  ///< Other rooms' folders, or single headers of theirs.
  bool may_use_mujoco{false};
};

/// A source file as the rules see it.
struct Source {
  std::string path;                ///< From the root, with forward slashes.
  std::vector<std::string> lines;  ///< Without line ends.
};

/// One `#include`.
struct Include {
  int line{0};  ///< Counts from 1.
  std::string target;
  bool is_quoted{false};  ///< "..." rather than <...>.
};

/// The includes of a source, in order. Commented-out ones do not count.
std::vector<Include> IncludesOf(const Source& source);

/// Violations of the include rules as `path:line: what`, one each. An empty list of sources and a
/// file that no room owns are violations. `rooms` lists every room once.
std::vector<std::string> IncludeViolations(const std::vector<Source>& sources,
                                           const std::vector<Room>& rooms);

/// Most lines that a file may have, and from where on it is worth a note.
constexpr int kMostLines = 500;
constexpr int kManyLines = 300;

/// Violations of form: the SPDX line first, `#pragma once` in headers, fewer than kMostLines.
std::vector<std::string> FormViolations(const std::vector<Source>& sources);

/// Files of kManyLines lines or more, as `path: n lines`.
std::vector<std::string> LongFiles(const std::vector<Source>& sources);

/// Reads every .h and .cc below `root`/`folder` for each of `folders`, sorted by path. Folders that
/// are absent are skipped.
std::vector<Source> ReadSources(const std::filesystem::path& root,
                                const std::vector<std::string>& folders);

}  // namespace sidestep::layering
