// SPDX-License-Identifier: BSD-3-Clause
#include "sim/process/start_program.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>

namespace sidestep {
namespace {

constexpr int kExitNoProgram = 127;  // as a shell's

// exec's old signature: it changes none of them.
std::vector<char*> Pointers(const std::vector<std::string>& texts) {
  std::vector<char*> pointers;
  for (const std::string& text : texts) pointers.push_back(const_cast<char*>(text.c_str()));
  pointers.push_back(nullptr);
  return pointers;
}

// All that a child needs, made before the fork: after it only what a signal handler may do is safe.
struct ChildPlan {
  std::vector<char*> arguments;
  std::vector<char*> environment;
  const char* working_dir;
  std::array<int, 3> streams;
  int failure;  // a pipe for errno, closed by a good exec
  pid_t parent;
};

[[noreturn]] void BecomeProgram(const ChildPlan& plan) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  signal(SIGPIPE, SIG_DFL);
  bool is_ready = getppid() == plan.parent;  // else it died before we could ask to be told
  for (int stream = 0; stream < 3; ++stream) {
    is_ready = is_ready && dup2(plan.streams[static_cast<std::size_t>(stream)], stream) == stream;
  }
  if (*plan.working_dir != '\0') is_ready = is_ready && chdir(plan.working_dir) == 0;
  if (is_ready) execvpe(plan.arguments[0], plan.arguments.data(), plan.environment.data());
  const int error = errno;
  [[maybe_unused]] const ssize_t wrote = write(plan.failure, &error, sizeof error);
  _exit(kExitNoProgram);
}

}  // namespace

pid_t StartProgram(const std::vector<std::string>& argv,
                   const std::vector<std::string>& environment,
                   const std::filesystem::path& working_dir, const std::array<int, 3>& streams) {
  int failure[2] = {-1, -1};
  if (pipe2(failure, O_CLOEXEC) != 0) return -errno;
  const ChildPlan plan{
      Pointers(argv), Pointers(environment), working_dir.c_str(), streams, failure[1], getpid()};
  const pid_t pid = fork();
  if (pid == 0) BecomeProgram(plan);
  int error = pid < 0 ? errno : 0;
  close(failure[1]);
  while (pid > 0 && read(failure[0], &error, sizeof error) < 0 && errno == EINTR) {
  }
  close(failure[0]);
  if (error == 0) return pid;
  if (pid > 0) waitpid(pid, nullptr, 0);
  return -error;
}

}  // namespace sidestep
