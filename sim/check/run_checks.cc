// SPDX-License-Identifier: BSD-3-Clause
#include "sim/check/run_checks.h"

#include <signal.h>
#include <sys/types.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <mutex>
#include <set>
#include <thread>

#include "models/support/require.h"
#include "sim/process/process.h"

namespace sidestep {
namespace {

Outcome NotRun(const CheckItem& item, const std::string& reason) {
  Outcome outcome;
  outcome.name = item.name;
  outcome.file = item.file;
  outcome.robot = item.robot;
  outcome.run_dir = item.run_dir;
  outcome.verdict = VerdictClass::kInvalid;
  outcome.reasons = {reason};
  return outcome;
}

// The processes that run, so that they can be told to end.
class RunningProcesses {
 public:
  void Add(pid_t pid) {
    const std::lock_guard<std::mutex> lock(mutex_);
    pids_.insert(pid);
    if (must_end_) kill(pid, SIGTERM);  // it was started while the others were told
  }
  void Remove(pid_t pid) {
    const std::lock_guard<std::mutex> lock(mutex_);
    pids_.erase(pid);
  }
  void TellToEnd() {
    const std::lock_guard<std::mutex> lock(mutex_);
    must_end_ = true;
    for (const pid_t pid : pids_) kill(pid, SIGTERM);
  }

 private:
  std::mutex mutex_;
  bool must_end_{false};
  std::set<pid_t> pids_;
};

Outcome RunOne(const CheckPlan& plan, const CheckItem& item, RunningProcesses* running) {
  std::vector<std::string> argv{plan.program.string(), "run",     item.file.string(), "--out",
                                item.run_dir.string(), "--force", "--quiet"};
  argv.insert(argv.end(), plan.arguments.begin(), plan.arguments.end());
  const auto start = std::chrono::steady_clock::now();
  try {
    if (plan.clear) plan.clear(item.run_dir);
    ProcessOptions options;
    options.time_limit_s = plan.time_limit_s;
    Process process(argv, options);
    const pid_t pid = process.pid();
    running->Add(pid);
    const ProcessResult result = process.Finish();
    running->Remove(pid);
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
    Outcome outcome = ReadOutcome(item.name, item.file, item.run_dir, result, wall.count());
    outcome.robot = item.robot;
    outcome.run_dir = item.run_dir;
    if (outcome.verdict == VerdictClass::kInvalid && wall.count() > plan.time_limit_s) {
      outcome.reasons.insert(outcome.reasons.begin(), "ERROR: took longer than the time limit");
    }
    return outcome;
  } catch (const std::exception& error) {
    return NotRun(item, std::string("ERROR: ") + error.what());
  }
}

}  // namespace

std::vector<Outcome> RunChecks(const CheckPlan& plan, const std::function<bool()>& stop,
                               const CheckListener& listener) {
  SIDESTEP_REQUIRE(plan.jobs >= 1, plan.jobs);
  constexpr auto kPollPeriod = std::chrono::milliseconds(20);
  std::vector<Outcome> outcomes(plan.items.size());
  RunningProcesses running;
  std::atomic<std::size_t> next{0};
  std::atomic<std::size_t> num_done{0};
  std::mutex listener_mutex;
  const auto work = [&] {
    for (std::size_t i = next++; i < plan.items.size(); i = next++) {
      outcomes[i] = stop() ? NotRun(plan.items[i], "INTERRUPTED: it was not started")
                           : RunOne(plan, plan.items[i], &running);
      const std::lock_guard<std::mutex> lock(listener_mutex);
      listener(outcomes[i], num_done + 1);
      ++num_done;
    }
  };
  const std::size_t num_workers = std::min(static_cast<std::size_t>(plan.jobs), plan.items.size());
  std::vector<std::thread> workers;
  for (std::size_t i = 0; i < num_workers; ++i) workers.emplace_back(work);
  bool is_stopping = false;
  while (num_done < plan.items.size()) {
    std::this_thread::sleep_for(kPollPeriod);
    if (!is_stopping && stop()) {
      is_stopping = true;  // once: a run takes a second request as an order to die
      running.TellToEnd();
    }
  }
  for (std::thread& worker : workers) worker.join();
  return outcomes;
}

}  // namespace sidestep
