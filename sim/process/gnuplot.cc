// SPDX-License-Identifier: BSD-3-Clause
#include "sim/process/gnuplot.h"

#include "sim/process/process.h"

namespace sidestep {

std::string GnuplotText(std::string_view text) {
  std::string quoted = "'";
  for (const char c : text) {
    if (c == '\'') quoted += '\'';
    quoted += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
  }
  return quoted + "'";
}

std::string RunGnuplot(const std::vector<std::string>& arguments, std::string_view input,
                       const std::filesystem::path& working_dir) {
  std::vector<std::string> words{"gnuplot", "-d"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  return RunTool(words, input, working_dir).out;
}

}  // namespace sidestep
