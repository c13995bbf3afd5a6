// SPDX-License-Identifier: BSD-3-Clause
#include "sim/process/process.h"

#include <poll.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <utility>

#include "models/support/config_error.h"
#include "models/support/require.h"
#include "sim/process/interrupt.h"
#include "sim/process/start_program.h"

extern char** environ;  // POSIX leaves its declaration to us.

namespace sidestep {
namespace {

constexpr std::size_t kQuotedBytes = 800;  ///< How much of a stderr goes into a message.
constexpr std::chrono::seconds kGrace{5};  // From being told to end to being killed.
constexpr int kPollPeriod_ms = 20;         ///< How late an interrupt may be seen.

// What a tool may know: where things are, not how somebody likes them.
constexpr const char* kToolVariables[] = {
    "PATH",           "HOME",          "TMPDIR",          "LD_LIBRARY_PATH",
    "XDG_CACHE_HOME", "XDG_DATA_DIRS", "FONTCONFIG_PATH", "FONTCONFIG_FILE"};

void CloseIfOpen(int* descriptor) {
  if (*descriptor >= 0) close(*descriptor);
  *descriptor = -1;
}

std::string ReadAll(int descriptor) {
  std::string text;
  char buffer[4096];
  off_t at = 0;
  for (ssize_t got = 0; (got = pread(descriptor, buffer, sizeof buffer, at)) > 0; at += got) {
    text.append(buffer, static_cast<std::size_t>(got));
  }
  return text;
}

int ExitCodeOf(int status) {
  return WIFSIGNALED(status) ? ProcessResult::kSignalBase + WTERMSIG(status) : WEXITSTATUS(status);
}

std::vector<std::string> EnvironmentOf(const ProcessOptions& options) {
  std::vector<std::string> variables;
  if (!options.is_tool) {
    for (char** variable = environ; *variable != nullptr; ++variable) {
      variables.emplace_back(*variable);
    }
    return variables;
  }
  for (const char* name : kToolVariables) {
    const char* value = std::getenv(name);
    if (value != nullptr) variables.push_back(std::string(name) + "=" + value);
  }
  variables.emplace_back("LC_ALL=C.UTF-8");
  return variables;
}

}  // namespace

/// Waits on a tool: a look at its socket, and an end once it has done nothing for too long.
class Process::Patience {
 public:
  explicit Patience(Process& process) : process_(process), last_sign_(Clock::now()) {}

  /// It did something.
  void Renew() { last_sign_ = Clock::now(); }

  /// Returns at one of `events`, at the other end's hanging up or after the poll period. Throws as
  /// Finish() once an interrupt or the patience ended the program.
  void Wait(short events) {
    pollfd socket{process_.input_, events, 0};
    poll(&socket, 1, kPollPeriod_ms);
    if ((socket.revents & POLLHUP) != 0 && events == 0) {
      poll(nullptr, 0, 1);  // it has let go of its input and is about to end
    }
    process_.KeepTimeLimit();
    if (!process_.options_.is_tool) return;
    const std::chrono::duration<double> idle = Clock::now() - last_sign_;
    if (!InterruptRequested() && idle.count() <= process_.options_.patience_s) return;
    process_.Kill();
    if (InterruptRequested()) throw Interrupted();
    throw ConfigError(process_.program_ + " did nothing for " +
                      std::to_string(static_cast<int>(process_.options_.patience_s)) +
                      " s and was killed");
  }

 private:
  Process& process_;
  Clock::time_point last_sign_;
};

bool SendAll(int socket, const void* data, std::size_t size) {
  const char* next = static_cast<const char*>(data);
  while (size > 0) {
    const ssize_t sent = send(socket, next, size, MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent <= 0) return false;
    next += sent;
    size -= static_cast<std::size_t>(sent);
  }
  return true;
}

Process::Process(const std::vector<std::string>& argv, ProcessOptions options)
    : options_(std::move(options)) {
  constexpr double kForever_s = 1e8;  // a clock's count overflows later
  ends_at_ += std::chrono::duration_cast<Clock::duration>(
      std::chrono::duration<double>(std::min(options_.time_limit_s, kForever_s)));
  SIDESTEP_REQUIRE(!argv.empty(), argv.size());
  program_ = argv.front();
  int ends[2] = {-1, -1};
  // A socket instead of a pipe: send() can be told not to raise SIGPIPE, write() can't.
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) {
    throw ConfigError("can't start " + program_ + ": " + std::strerror(errno));
  }
  input_ = ends[0];
  output_ = memfd_create("sidestep_stdout", MFD_CLOEXEC);
  error_ = memfd_create("sidestep_stderr", MFD_CLOEXEC);
  pid_ =
      StartProgram(argv, EnvironmentOf(options_), options_.working_dir, {ends[1], output_, error_});
  close(ends[1]);
  if (pid_ < 0) {
    for (int* descriptor : {&input_, &output_, &error_}) CloseIfOpen(descriptor);
    throw ConfigError("can't start " + program_ + ": " + std::strerror(-pid_) +
                      " (is it installed and in PATH?)");
  }
}

Process::~Process() {
  Kill();
  for (int* descriptor : {&input_, &output_, &error_}) CloseIfOpen(descriptor);
}

void Process::KeepTimeLimit() {
  if (Clock::now() <= ends_at_) return;
  kill(pid_, was_told_to_end_ ? SIGKILL : SIGTERM);
  was_told_to_end_ = true;
  ends_at_ = Clock::now() + kGrace;
}

void Process::Kill() {
  if (pid_ <= 0) return;
  kill(pid_, SIGKILL);
  while (waitpid(pid_, nullptr, 0) < 0 && errno == EINTR) {
  }
  pid_ = -1;
}

bool Process::Write(const void* data, std::size_t size) {
  if (!options_.is_tool) return SendAll(input_, data, size);
  const char* next = static_cast<const char*>(data);
  Patience patience(*this);
  while (size > 0) {
    const ssize_t sent = send(input_, next, size, MSG_NOSIGNAL | MSG_DONTWAIT);
    if (sent > 0) {
      next += sent;
      size -= static_cast<std::size_t>(sent);
      patience.Renew();
    } else if (sent < 0 && (errno == EAGAIN || errno == EINTR)) {
      patience.Wait(POLLOUT);
    } else {
      return false;
    }
  }
  return true;
}

ProcessResult Process::Finish() {
  SIDESTEP_REQUIRE(pid_ > 0, pid_);
  shutdown(input_, SHUT_WR);  // its end of input; that it hangs up then tells us of its end
  int status = 0;
  for (Patience patience(*this); waitpid(pid_, &status, WNOHANG) == 0;) patience.Wait(0);
  pid_ = -1;
  return {ExitCodeOf(status), ReadAll(output_), ReadAll(error_)};
}

ProcessResult RunProcess(const std::vector<std::string>& argv, std::string_view input,
                         const ProcessOptions& options) {
  Process process(argv, options);
  process.Write(input.data(), input.size());
  return process.Finish();
}

ProcessResult RunOrThrow(const std::vector<std::string>& argv, std::string_view input,
                         const ProcessOptions& options) {
  ProcessResult result = RunProcess(argv, input, options);
  if (result.exit_code != 0) throw ConfigError(DescribeFailure(argv.front(), result));
  return result;
}

ProcessResult RunTool(const std::vector<std::string>& argv, std::string_view input,
                      const std::filesystem::path& working_dir) {
  return RunOrThrow(argv, input, ToolOptions(working_dir));
}

std::string DescribeFailure(const std::string& program, const ProcessResult& result) {
  std::string quoted = result.err;
  while (!quoted.empty() && (quoted.back() == '\n' || quoted.back() == ' ')) quoted.pop_back();
  if (quoted.size() > kQuotedBytes) quoted = "..." + quoted.substr(quoted.size() - kQuotedBytes);
  return program + " failed with exit code " + std::to_string(result.exit_code) +
         (quoted.empty() ? " and said nothing" : ": " + quoted);
}

}  // namespace sidestep
