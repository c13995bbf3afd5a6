// SPDX-License-Identifier: BSD-3-Clause
#include "sim/render/segment_process.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <exception>

#include "models/support/config_error.h"

namespace sidestep::render {
namespace {

constexpr char kStep = '.';   // one byte a frame drawn
constexpr char kError = '!';  // then the message, to the end of the stream

void WriteAll(int descriptor, const std::string& text) {
  for (std::size_t at = 0; at < text.size();) {
    const ssize_t wrote = write(descriptor, text.data() + at, text.size() - at);
    if (wrote < 0 && errno == EINTR) continue;
    if (wrote <= 0) return;
    at += static_cast<std::size_t>(wrote);
  }
}

// The child's whole life. _exit: the parent's buffers and destructors are not ours to run.
[[noreturn]] void RunChild(const std::function<void(const std::function<void()>&)>& work,
                           int report, pid_t parent) {
  signal(SIGPIPE, SIG_IGN);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(1);
  int status = 0;
  try {
    work([&] { WriteAll(report, std::string(1, kStep)); });
  } catch (const std::exception& failure) {
    WriteAll(report, kError + std::string(failure.what()));
    status = 1;
  } catch (...) {
    WriteAll(report, kError + std::string("unknown error"));
    status = 1;
  }
  _exit(status);
}

}  // namespace

SegmentProcess::SegmentProcess(const std::function<void(const std::function<void()>&)>& work) {
  int ends[2] = {-1, -1};
  if (pipe2(ends, O_CLOEXEC) != 0) {
    throw ConfigError(std::string("can't create a pipe: ") + std::strerror(errno));
  }
  const pid_t parent = getpid();
  pid_ = fork();
  if (pid_ == 0) {
    close(ends[0]);
    RunChild(work, ends[1], parent);
  }
  const int failure = errno;
  close(ends[1]);
  report_ = ends[0];
  if (pid_ < 0) {
    close(report_);
    throw ConfigError(std::string("can't create a process: ") + std::strerror(failure));
  }
}

void SegmentProcess::Kill() {
  if (pid_ > 0) kill(pid_, SIGKILL);
}

SegmentProcess::~SegmentProcess() {
  close(report_);
  if (pid_ <= 0) return;
  Kill();
  while (waitpid(pid_, nullptr, 0) < 0 && errno == EINTR) {
  }
}

bool SegmentProcess::ReadReports() {
  char buffer[512];
  ssize_t got = 0;
  while ((got = read(report_, buffer, sizeof buffer)) < 0 && errno == EINTR) {
  }
  for (ssize_t i = 0; i < got; ++i) {
    if (has_error_) {
      error_ += buffer[i];
    } else if (buffer[i] == kStep) {
      ++steps_done_;
    } else {
      has_error_ = true;
    }
  }
  if (got > 0) return true;
  int status = 0;
  while (waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
  }
  pid_ = -1;
  if (error_.empty() && status != 0) {
    error_ = "a rendering process died with status " + std::to_string(status);
  }
  return false;
}

}  // namespace sidestep::render
