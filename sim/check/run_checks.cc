// SPDX-License-Identifier: BSD-3-Clause
#include "sim/check/run_checks.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <mutex>
#include <thread>

#include "models/support/require.h"
#include "sim/process/process.h"

namespace sidestep {
namespace {

Outcome NotRun(const CheckItem& item, const std::string& reason) {
  Outcome outcome;
  outcome.name = item.name;
  outcome.file = item.file;
  outcome.run_class = RunClass::kInvalid;
  outcome.reasons = {reason};
  return outcome;
}

Outcome RunOne(const CheckPlan& plan, const CheckItem& item) {
  std::vector<std::string> argv{plan.program.string(), "run",     item.file.string(), "--out",
                                item.run_dir.string(), "--force", "--quiet"};
  argv.insert(argv.end(), plan.arguments.begin(), plan.arguments.end());
  const auto start = std::chrono::steady_clock::now();
  try {
    const ProcessResult process = RunProcess(argv);
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
    return ReadOutcome(item.name, item.file, item.run_dir, process, wall.count());
  } catch (const std::exception& error) {
    return NotRun(item, std::string("ERROR: ") + error.what());
  }
}

}  // namespace

std::vector<Outcome> RunChecks(const CheckPlan& plan, const std::function<bool()>& stop,
                               const CheckListener& listener) {
  SIDESTEP_REQUIRE(plan.jobs >= 1, plan.jobs);
  std::vector<Outcome> outcomes(plan.items.size());
  std::atomic<std::size_t> next{0};
  std::size_t num_done = 0;
  std::mutex listener_mutex;
  const auto work = [&] {
    for (std::size_t i = next++; i < plan.items.size(); i = next++) {
      outcomes[i] = stop() ? NotRun(plan.items[i], "INTERRUPTED: it was not started")
                           : RunOne(plan, plan.items[i]);
      const std::lock_guard<std::mutex> lock(listener_mutex);
      listener(outcomes[i], ++num_done);
    }
  };
  const std::size_t num_workers = std::min(static_cast<std::size_t>(plan.jobs), plan.items.size());
  std::vector<std::thread> workers;
  for (std::size_t i = 0; i < num_workers; ++i) workers.emplace_back(work);
  for (std::thread& worker : workers) worker.join();
  return outcomes;
}

}  // namespace sidestep
