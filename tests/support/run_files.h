// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// run_files: the files of a run as what they say of it, without what the clock on the wall wrote.

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace sidestep {

/// Whole text of a file; empty if there is none.
inline std::string TextOf(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

/// A table's text without the columns that a clock wrote: those whose names begin with `wall_` or
/// `cpu_`.
inline std::string WithoutWallClock(const std::filesystem::path& csv) {
  std::istringstream in(TextOf(csv));
  std::string header;
  std::getline(in, header);
  std::vector<bool> kept;
  std::stringstream names(header);
  for (std::string name; std::getline(names, name, ',');) {
    kept.push_back(!name.starts_with("wall_") && !name.starts_with("cpu_"));
  }
  std::string text;
  for (std::string line; std::getline(in, line);) {
    std::stringstream cells(line);
    std::size_t column = 0;
    for (std::string cell; std::getline(cells, cell, ',');) {
      if (kept[column++]) text += cell + ",";
    }
    text += "\n";
  }
  return text;
}

}  // namespace sidestep
