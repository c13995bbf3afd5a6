// SPDX-License-Identifier: BSD-3-Clause
// Time of one QP solve over 1000 problems a family, cold and warm-started from a neighbour.
//   qp_bench [--benchmark_filter=torque]
// Counters: p50, p99 over the problems, each at its best of the repetitions (what a problem costs
// on an idle machine); max over every solve (what the machine's other work adds).
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdint>
#include <ctime>
#include <limits>
#include <string>
#include <vector>

#include "controller/wbc/qp/dense_qp.h"
#include "tests/support/random_dense_qp.h"

namespace sidestep::wbc {
namespace {

constexpr std::uint64_t kProblems = 1000;

// Time this thread spent on the processor: other programs' load does not count.
double ThreadTime_us() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e6 * static_cast<double>(now.tv_sec) + 1e-3 * static_cast<double>(now.tv_nsec);
}

double TimedSolve_us(DenseQpSolver& solver, const DenseQpProblem& problem,
                     const DenseQpSolution* guess) {
  const double start_us = ThreadTime_us();
  benchmark::DoNotOptimize(solver.Solve(problem, guess).x.data());
  return ThreadTime_us() - start_us;
}

void SolveFamily(benchmark::State& state, QpFamily family, bool is_warm) {
  std::vector<DenseQpProblem> problems;
  std::vector<DenseQpProblem> neighbours;
  for (std::uint64_t seed = 0; seed < kProblems; ++seed) {
    problems.push_back(MakeRandomQp(family, seed));
    neighbours.push_back(MakeNeighbourQp(problems.back(), seed));
  }
  DenseQpSolver solver(RandomQpMaxima());
  std::vector<double> best_us(kProblems, std::numeric_limits<double>::infinity());
  double max_us = 0.0;
  std::int64_t changes = 0;
  for (auto _ : state) {
    double total_us = 0.0;
    for (std::uint64_t k = 0; k < kProblems; ++k) {
      const DenseQpSolution& last = solver.Solve(problems[k]);  // also warms the caches
      const double time_us = TimedSolve_us(solver, neighbours[k], is_warm ? &last : nullptr);
      best_us[k] = std::min(best_us[k], time_us);
      max_us = std::max(max_us, time_us);
      total_us += time_us;
      changes += last.iterations;  // the solver's record: by now of the neighbour
    }
    state.SetIterationTime(1e-6 * total_us / static_cast<double>(kProblems));
  }
  std::sort(best_us.begin(), best_us.end());
  state.counters["p50_us"] = best_us[kProblems / 2];
  state.counters["p99_us"] = best_us[kProblems * 99 / 100];
  state.counters["max_us"] = max_us;
  state.counters["changes"] =
      benchmark::Counter(static_cast<double>(changes) / static_cast<double>(kProblems),
                         benchmark::Counter::kAvgIterations);
}

const bool kIsRegistered = [] {
  for (const QpFamily family : kAllQpFamilies) {
    for (const bool is_warm : {false, true}) {
      const std::string name = std::string(ToString(family)) + (is_warm ? "/warm" : "/cold");
      benchmark::RegisterBenchmark(name.c_str(), SolveFamily, family, is_warm)
          ->UseManualTime()
          ->Iterations(10)
          ->Unit(benchmark::kMicrosecond);
    }
  }
  return true;
}();

}  // namespace
}  // namespace sidestep::wbc
