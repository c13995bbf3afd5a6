// SPDX-License-Identifier: BSD-3-Clause
// sidestep: the program. Parses the command line, hands over to a command, and turns every way a
// command may end into an exit code.

#include <fcntl.h>
#include <mujoco/mujoco.h>
#include <poll.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <filesystem>
#include <string>

#include "models/support/config_error.h"
#include "sim/apps/commands/commands.h"
#include "sim/apps/commands/exit_code.h"
#include "sim/process/interrupt.h"

namespace sidestep {
namespace {

constexpr const char* kThreadLimits[] = {"OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS"};

// Threads under the linear algebra make Ipopt's MUMPS hang or vary. Libraries read the limit when
// they are loaded, before main: so it is set, and the program started over, once.
void PinThreads(char** argv) {
  bool is_pinned = true;
  for (const char* name : kThreadLimits) {
    const char* value = std::getenv(name);
    is_pinned = is_pinned && value != nullptr && std::strcmp(value, "1") == 0;
    setenv(name, "1", 1);
  }
  if (!is_pinned) execv("/proc/self/exe", argv);  // returns only if it fails: go on as we are
}

// A reader that goes away (`sidestep run ... | head -1`) ends no run. Standard streams that are
// closed lead nowhere instead: the next file opened would take their place, and messages land in
// it.
void GuardStandardStreams() {
  std::signal(SIGPIPE, SIG_IGN);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (fcntl(stream, F_GETFD) == -1 && errno == EBADF) open("/dev/null", O_RDWR);
  }
}

// A pipe that nobody reads any more: who went away knew enough.
bool HasLostItsReader(int stream) {
  pollfd state{stream, POLLOUT, 0};
  return poll(&state, 1, 0) == 1 && (state.revents & POLLERR) != 0;
}

// MuJoCo calls this on errors it can't return from; it must not come back to it.
void EndOnMujocoError(const char* message) {
  std::fflush(stdout);
  std::fprintf(stderr, "sidestep: error: MuJoCo: %s\n", message);
  std::fflush(stderr);
  _exit(kExitInvalid);
}

void PrintError(const char* prefix, std::string message) {
  std::replace(message.begin(), message.end(), '\n', ' ');
  std::fflush(stdout);
  std::fprintf(stderr, "%s%s\n", prefix, message.c_str());
}

int RunCommandLine(int argc, char** argv) {
  int exit_code = kExitPass;
  CLI::App app("Pushes simulated legged robots and tells you whether they catch themselves.",
               "sidestep");
  app.set_version_flag("--version", VersionText());
  app.require_subcommand(1);
  AddRunCommand(app, exit_code);
  AddCheckCommand(app, exit_code);
  AddSweepCommand(app, exit_code);
  AddCompareCommand(app, exit_code);
  AddValidateCommand(app, exit_code);
  AddRenderCommand(app, exit_code);
  AddPlotCommand(app, exit_code);
  AddReportCommand(app, exit_code);
  AddExportCommand(app, exit_code);
  AddFilmCommand(app, exit_code);
  AddScenariosCommand(app, exit_code);
  AddRobotsCommand(app, exit_code);
  AddKeysCommand(app, exit_code);
  AddMetricsCommand(app, exit_code);
  AddSchemaCommand(app, exit_code);
  AddLimitCommand(app, exit_code);
  AddSolveCommand(app, exit_code);
  RefuseEmptyWords(app);
  app.footer("Exit codes: 0 pass, 1 verdict fail, 2 bad input or usage, 3 invalid run.");
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& request) {  // --help, --version
    return app.exit(request);
  } catch (const CLI::ParseError& error) {
    PrintError("sidestep: error: ", std::string(error.what()) + " (see --help)");
    return kExitBadInput;
  }
  errno = 0;
  const bool is_said = std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
  if (is_said || HasLostItsReader(STDOUT_FILENO) || exit_code != kExitPass) return exit_code;
  PrintError("sidestep: error: ", std::string("standard output can't be written") +
                                      (errno == 0 ? "" : std::string(": ") + std::strerror(errno)));
  return kExitBadInput;
}

}  // namespace
}  // namespace sidestep

int main(int argc, char** argv) {
  using namespace sidestep;  // main can't be inside it
  GuardStandardStreams();
  PinThreads(argv);
  mju_user_error = EndOnMujocoError;
  InstallInterruptHandlers();
  try {
    return RunCommandLine(argc, argv);
  } catch (const ConfigError& error) {
    std::fflush(stdout);
    std::fprintf(stderr, "%s\n", error.what());  // a line each of what is wrong
    return kExitBadInput;
  } catch (const Interrupted& end) {
    PrintError("sidestep: ", end.what());
    return kExitInvalid;
  } catch (const std::filesystem::filesystem_error& error) {
    PrintError("sidestep: error: ", error.what());  // a path the user gave and we may not touch
    return kExitBadInput;
  } catch (const std::exception& error) {
    PrintError("sidestep: internal error: ", error.what());
    return kExitInvalid;
  }
}
