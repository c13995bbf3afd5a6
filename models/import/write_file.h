// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// write_file: a file of an import, whole.

#include <filesystem>
#include <string>

namespace sidestep::importer {

/// Replaces `file`, whose folder must be there. Throws ConfigError if it can't be written.
void WriteFile(const std::filesystem::path& file, const std::string& text);

}  // namespace sidestep::importer
