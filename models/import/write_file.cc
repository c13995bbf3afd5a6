// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/write_file.h"

#include <fstream>

#include "models/support/config_error.h"

namespace sidestep::importer {

void WriteFile(const std::filesystem::path& file, const std::string& text) {
  std::ofstream out(file, std::ios::binary);
  out << text;
  out.close();
  if (!out) throw ConfigError(file.string() + ": error: can't be written");
}

}  // namespace sidestep::importer
