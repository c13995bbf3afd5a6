// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// progress: how far a long command is, on stderr.

#include <chrono>
#include <cstddef>
#include <string>

namespace sidestep {

/// On a terminal one line that is drawn over, with a bar and the time left; elsewhere a plain line
/// every few seconds at most; nothing if quiet. Removes its line when it ends.
class Progress {
 public:
  Progress(std::string label, bool is_quiet);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// @param share   Done so far, in 0..1.
  /// @param detail  A few words, such as "1.2 of 5.0 s simulated". May be empty.
  void Update(double share, const std::string& detail);

  /// Prints a line of its own to stderr, above the bar; nothing if quiet.
  void Say(const std::string& line);

 private:
  void Clear();

  std::string label_;
  bool is_quiet_;
  bool is_terminal_;
  std::size_t drawn_{0};  ///< Characters of the line on the terminal.
  std::chrono::steady_clock::time_point start_;
  std::chrono::steady_clock::time_point last_;
};

/// The words of a progress line: "label [#####-----]  50 %, detail, about 12 s left". Without bar
/// if `bar_width` is 0. The time left is told from 2 % on, when it begins to mean something.
std::string ProgressText(const std::string& label, double share, const std::string& detail,
                         double elapsed_s, std::size_t bar_width);

}  // namespace sidestep
