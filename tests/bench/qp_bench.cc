// SPDX-License-Identifier: BSD-3-Clause
// Time of one QP solve over 1000 problems a family, cold and warm-started from a neighbour.
//   qp_bench [--benchmark_filter=torque]      counters: p50, p99, max in microseconds
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdint>
#include <ctime>
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
  std::vector<double> times_us;
  double changes = 0.0;
  for (auto _ : state) {
    double total_us = 0.0;
    for (std::uint64_t k = 0; k < kProblems; ++k) {
      const DenseQpSolution& last = solver.Solve(problems[k]);  // also warms the caches
      times_us.push_back(TimedSolve_us(solver, neighbours[k], is_warm ? &last : nullptr));
      total_us += times_us.back();
      changes += last.iterations;
    }
    state.SetIterationTime(1e-6 * total_us / static_cast<double>(kProblems));
  }
  std::sort(times_us.begin(), times_us.end());
  state.counters["p50_us"] = times_us[times_us.size() / 2];
  state.counters["p99_us"] = times_us[times_us.size() * 99 / 100];
  state.counters["max_us"] = times_us.back();
  state.counters["changes"] = changes / static_cast<double>(times_us.size());
}

const bool kIsRegistered = [] {
  for (const QpFamily family : kAllQpFamilies) {
    for (const bool is_warm : {false, true}) {
      const std::string name = std::string(ToString(family)) + (is_warm ? "/warm" : "/cold");
      benchmark::RegisterBenchmark(name.c_str(), SolveFamily, family, is_warm)
          ->UseManualTime()
          ->Iterations(5)
          ->Unit(benchmark::kMicrosecond);
    }
  }
  return true;
}();

}  // namespace
}  // namespace sidestep::wbc
