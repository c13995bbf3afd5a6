// SPDX-License-Identifier: BSD-3-Clause
#include "sim/sweep/sweep_worker.h"

#include <signal.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>
#include <utility>

#include "models/support/config_error.h"
#include "models/support/require.h"
#include "sim/process/interrupt.h"
#include "sim/process/process.h"
#include "sim/sweep/cell_runner.h"

namespace sidestep {
namespace {

bool SendLine(int socket, const std::string& line) {
  const std::string text = line + "\n";
  return SendAll(socket, text.data(), text.size());
}

// The child's side.
class Worker {
 public:
  Worker(const WorkerSetup& setup, int socket) : setup_(setup), socket_(socket) {}

  // Runs rays until there are no more.
  void Work() {
    std::string line;
    while (ReadLine(&line)) {
      if (!RunRay(setup_.plan->rays.at(std::stoul(line)))) {
        Say("s");
        return;
      }
      Say("d");
    }
  }

  void Say(const std::string& line) {
    if (!SendLine(socket_, line)) _exit(1);  // the parent is gone
  }

 private:
  bool ReadLine(std::string* line) {
    line->clear();
    for (char letter = 0;;) {
      const ssize_t got = read(socket_, &letter, 1);
      if (got < 0 && errno == EINTR) continue;
      if (got <= 0) return false;
      if (letter == '\n') return true;
      *line += letter;
    }
  }

  // False if the user interrupted.
  bool RunRay(const PlannedRay& planned) {
    const SweepSpec& spec = setup_.plan->spec;
    if (PlanRay(spec, planned.ray, ProgramHash()).id != planned.id) {
      throw ConfigError((setup_.folder / "manifest.csv").string() + ": error: ray " +
                        std::to_string(planned.ray.index) +
                        " was planned from another scenario or robot than there is now; plan the " +
                        "sweep again in another folder");
    }
    const LimitResult result =
        WalkRay(spec, planned.ray, [&](const CellKey& cell) { return OutcomeOf(planned, cell); });
    return result.is_complete;
  }

  std::optional<CellOutcome> OutcomeOf(const PlannedRay& planned, const CellKey& cell) {
    const auto known = setup_.rows->find(NameOf(cell));
    if (known != setup_.rows->end()) return known->second.outcome;
    if (InterruptRequested()) return std::nullopt;
    const SweepSpec& spec = setup_.plan->spec;
    CellResult crash;
    crash.reasons = "ERROR: the program ended in this run";
    Say("b" + MakeRow(spec, planned.ray, planned.id, cell, crash).line);
    const Scenario scenario = ScenarioOf(spec, planned.ray, cell);
    const CellResult result = runner_.Run(scenario);
    if (result.was_interrupted) return std::nullopt;
    KeepRun(setup_.keep, result.outcome, scenario, KeptRunFolder(setup_.folder, cell));
    if (InterruptRequested()) return std::nullopt;  // what is kept may not be whole
    Say("r" + MakeRow(spec, planned.ray, planned.id, cell, result).line);
    return result.outcome;
  }

  const WorkerSetup& setup_;
  int socket_;
  CellRunner runner_;
};

[[noreturn]] void WorkAndExit(const WorkerSetup& setup, int socket) {
  Worker worker(setup, socket);
  const auto one_line = [](std::string text) {
    for (char& letter : text) letter = letter == '\n' ? ' ' : letter;
    return text;
  };
  try {
    worker.Work();
  } catch (const ConfigError& error) {
    worker.Say("e" + one_line(error.what()));
  } catch (const std::exception& error) {
    worker.Say("x" + one_line(error.what()));
  }
  _exit(0);
}

}  // namespace

SweepWorker::SweepWorker(const WorkerSetup& setup, RowFile* file,
                         const std::vector<SweepWorker*>& others) {
  int ends[2] = {-1, -1};
  std::fflush(nullptr);
  const pid_t parent = getpid();
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0 || (pid_ = fork()) < 0) {
    throw ConfigError(std::string("error: can't start a process: ") + std::strerror(errno));
  }
  if (pid_ == 0) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent) _exit(1);
    close(ends[0]);
    file->Forget();
    for (const SweepWorker* other : others) close(other->socket_);
    WorkAndExit(setup, ends[1]);
  }
  close(ends[1]);
  socket_ = ends[0];
}

SweepWorker::~SweepWorker() {
  if (pid_ > 0) kill(pid_, SIGKILL);
  Finish();
}

void SweepWorker::Assign(std::size_t place) {
  ray = place;
  SendLine(socket_, std::to_string(place));  // one that is gone shows when it is read from
}

std::optional<std::vector<std::string>> SweepWorker::Read() {
  char buffer[4096];
  const ssize_t got = read(socket_, buffer, sizeof buffer);
  if (got < 0 && errno == EINTR) return std::vector<std::string>();
  if (got <= 0) return std::nullopt;
  unread_.append(buffer, static_cast<std::size_t>(got));
  std::vector<std::string> lines;
  for (std::size_t end = 0; (end = unread_.find('\n')) != std::string::npos;) {
    lines.push_back(unread_.substr(0, end));
    unread_.erase(0, end + 1);
  }
  return lines;
}

int SweepWorker::Finish() {
  if (socket_ >= 0) shutdown(socket_, SHUT_WR);
  int status = 0;
  if (pid_ > 0) {
    while (waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
    }
  }
  pid_ = -1;
  if (socket_ >= 0) close(socket_);
  socket_ = -1;
  return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

}  // namespace sidestep
