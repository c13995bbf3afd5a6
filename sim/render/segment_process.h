// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// segment_process: a forked copy of this program that draws a share of the frames.

#include <sys/types.h>

#include <functional>
#include <string>

namespace sidestep::render {

/// A child process that runs one function. It reports each step and, at its end, success or the
/// text of the exception that ended it. Fork before any OpenGL context exists, and from a
/// process with one thread.
class SegmentProcess {
 public:
  /// Forks. In the child runs `work(report_step)` and exits without returning; the child dies
  /// with its parent. @throws ConfigError if no process can be created.
  explicit SegmentProcess(const std::function<void(const std::function<void()>&)>& work);
  SegmentProcess(const SegmentProcess&) = delete;
  SegmentProcess& operator=(const SegmentProcess&) = delete;

  /// Kills the child if it still runs, and waits for it.
  ~SegmentProcess();

  /// Kills the child, without waiting for it: of several, all at once.
  void Kill();

  /// Descriptor to poll: readable when there is something for ReadReports().
  int report_descriptor() const { return report_; }

  /// Takes in what the child has reported; blocks until there is something. Returns false once
  /// the child has ended.
  bool ReadReports();

  int steps_done() const { return steps_done_; }

  /// Empty if the child succeeded. Valid once ReadReports() has returned false.
  const std::string& error() const { return error_; }

 private:
  pid_t pid_{-1};
  int report_{-1};
  int steps_done_{0};
  bool has_error_{false};
  std::string error_;
};

}  // namespace sidestep::render
