// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// process: starts a program (ffmpeg, gnuplot) with an argument vector, feeds it and waits for it.
//
// Never through a shell, so no quoting and no injection by a folder's name. What the program
// prints goes to memory files, not pipes: it can never block on us while we block on it. However we
// end, even by SIGKILL, it ends with us.

#include <sys/types.h>

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace sidestep {

/// Writes all of `size` bytes to a socket; false if its other end is gone. Never raises SIGPIPE.
bool SendAll(int socket, const void* data, std::size_t size);

/// How a program ended.
struct ProcessResult {
  static constexpr int kSignalBase = 128;

  int exit_code{0};  ///< Its exit status; kSignalBase + signal number if a signal ended it.
  std::string out;   ///< What it wrote to standard output.
  std::string err;   ///< What it wrote to standard error.
};

/// How a program is run.
struct ProcessOptions {
  std::filesystem::path working_dir{};  ///< Ours if empty.

  /// It draws for us (gnuplot, ffmpeg): a user's settings don't change what it does, as of the
  /// environment it sees only where programs, libraries, fonts and scratch files are; an interrupt
  /// kills it, and so does `patience_s`.
  bool is_tool{false};
  double patience_s{120.0};  ///< Of a tool: the longest that it may take no input, or not end.
  /// When it takes longer it gets SIGTERM, and is killed a little later.
  double time_limit_s{std::numeric_limits<double>::infinity()};
};

/// A tool's.
inline ProcessOptions ToolOptions(const std::filesystem::path& working_dir = {}) {
  ProcessOptions options;
  options.working_dir = working_dir;
  options.is_tool = true;
  return options;
}

/// A running program. Its standard input is ours to write; it inherits no other descriptor. It dies
/// with the thread that started it.
class Process {
 public:
  /// Starts argv[0], looked up in PATH.
  /// @throws ConfigError if the program can't be found or started.
  explicit Process(const std::vector<std::string>& argv, ProcessOptions options = {});
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  /// Kills the program and waits for it, unless Finish() was called.
  ~Process();

  /// Writes all of `size` bytes to the program's input. Returns false if the program has closed
  /// it (it failed: Finish() tells why). Never raises SIGPIPE. Of a tool it throws as Finish().
  bool Write(const void* data, std::size_t size);

  /// Its process id, for kill(); -1 after Finish().
  pid_t pid() const { return pid_; }

  /// Closes the program's input and waits for its end. Call once.
  /// @throws Interrupted or ConfigError, of a tool that an interrupt or our patience has ended.
  ProcessResult Finish();

 private:
  using Clock = std::chrono::steady_clock;
  class Patience;
  void Kill();
  void KeepTimeLimit();

  std::string program_;
  ProcessOptions options_;
  Clock::time_point ends_at_{Clock::now()};
  bool was_told_to_end_{false};
  pid_t pid_{-1};
  int input_{-1};
  int output_{-1};
  int error_{-1};
};

/// Runs a program to its end with `input` on its standard input.
/// @throws ConfigError if it can't be started. A failing program is no exception: see exit_code.
ProcessResult RunProcess(const std::vector<std::string>& argv, std::string_view input = {},
                         const ProcessOptions& options = {});

/// As RunProcess, but a non-zero exit is a ConfigError that quotes the program's last words.
ProcessResult RunOrThrow(const std::vector<std::string>& argv, std::string_view input = {},
                         const ProcessOptions& options = {});

/// RunOrThrow of a tool.
ProcessResult RunTool(const std::vector<std::string>& argv, std::string_view input = {},
                      const std::filesystem::path& working_dir = {});

/// The text of a failure, for error messages: program, exit code and the end of its stderr.
std::string DescribeFailure(const std::string& program, const ProcessResult& result);

}  // namespace sidestep
