// SPDX-License-Identifier: BSD-3-Clause
#include "sim/process/process.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

#include "models/support/config_error.h"
#include "models/support/require.h"

extern char** environ;  // POSIX leaves its declaration to us.

namespace sidestep {
namespace {

constexpr std::size_t kQuotedBytes = 800;  ///< How much of a stderr goes into a message.

class SpawnActions {
 public:
  SpawnActions() { posix_spawn_file_actions_init(&actions_); }
  ~SpawnActions() { posix_spawn_file_actions_destroy(&actions_); }
  SpawnActions(const SpawnActions&) = delete;
  SpawnActions& operator=(const SpawnActions&) = delete;
  posix_spawn_file_actions_t* get() { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_;
};

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

int WaitFor(pid_t pid) {
  int status = 0;
  while (waitpid(pid, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

}  // namespace

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

Process::Process(const std::vector<std::string>& argv, const std::filesystem::path& working_dir) {
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

  SpawnActions actions;
  posix_spawn_file_actions_adddup2(actions.get(), ends[1], STDIN_FILENO);
  posix_spawn_file_actions_adddup2(actions.get(), output_, STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(actions.get(), error_, STDERR_FILENO);
  if (!working_dir.empty()) {
    posix_spawn_file_actions_addchdir_np(actions.get(), working_dir.c_str());
  }
  std::vector<char*> arguments;
  for (const std::string& argument : argv) {
    arguments.push_back(const_cast<char*>(argument.c_str()));  // exec's old signature
  }
  arguments.push_back(nullptr);
  const int failure =
      posix_spawnp(&pid_, program_.c_str(), actions.get(), nullptr, arguments.data(), environ);
  close(ends[1]);
  if (failure != 0) {
    for (int* descriptor : {&input_, &output_, &error_}) CloseIfOpen(descriptor);
    throw ConfigError("can't start " + program_ + ": " + std::strerror(failure) +
                      " (is it installed and in PATH?)");
  }
}

Process::~Process() {
  for (int* descriptor : {&input_, &output_, &error_}) CloseIfOpen(descriptor);
  if (pid_ > 0) {
    kill(pid_, SIGKILL);
    WaitFor(pid_);
  }
}

bool Process::Write(const void* data, std::size_t size) { return SendAll(input_, data, size); }

ProcessResult Process::Finish() {
  SIDESTEP_REQUIRE(pid_ > 0, pid_);
  CloseIfOpen(&input_);
  ProcessResult result;
  result.exit_code = WaitFor(std::exchange(pid_, -1));
  result.out = ReadAll(output_);
  result.err = ReadAll(error_);
  return result;
}

ProcessResult RunProcess(const std::vector<std::string>& argv, std::string_view input,
                         const std::filesystem::path& working_dir) {
  Process process(argv, working_dir);
  process.Write(input.data(), input.size());
  return process.Finish();
}

ProcessResult RunOrThrow(const std::vector<std::string>& argv, std::string_view input,
                         const std::filesystem::path& working_dir) {
  ProcessResult result = RunProcess(argv, input, working_dir);
  if (result.exit_code != 0) throw ConfigError(DescribeFailure(argv.front(), result));
  return result;
}

std::string DescribeFailure(const std::string& program, const ProcessResult& result) {
  std::string quoted = result.err;
  while (!quoted.empty() && (quoted.back() == '\n' || quoted.back() == ' ')) quoted.pop_back();
  if (quoted.size() > kQuotedBytes) quoted = "..." + quoted.substr(quoted.size() - kQuotedBytes);
  return program + " failed with exit code " + std::to_string(result.exit_code) +
         (quoted.empty() ? " and said nothing" : ": " + quoted);
}

}  // namespace sidestep
