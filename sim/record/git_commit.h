// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// git_commit: the source that this program was built from; cmake/git_commit.cmake writes the body.

namespace sidestep {

/// The commit's first 12 digits, with `-dirty` if the tree was changed since; "unknown" of sources
/// without git.
const char* GitCommit();

}  // namespace sidestep
