// SPDX-License-Identifier: BSD-3-Clause
// Time to solve one MPC problem, cold and warm, on reference problems. Counters: percentiles of the
// solve time over all solves of a case, iterations, and the share of the time that is not spent in
// evaluating the problem. p50, p99 and max are wall time, what a deadline sees: run it on an idle
// machine.
//
// The table that compares the back ends on many problems is mpc_table_bench.cc's.
//
// That share is 1 - iterations * (one evaluation of cost, gradient, constraints, Jacobian and
// Hessian) / (time of a solve), both in CPU time so that other processes do not distort it: Ipopt's
// own timing statistics are out of reach behind the solver interface, and what is not evaluation is
// factorisation, MUMPS's bookkeeping and Ipopt's vectors. Line searches that need a second trial
// point are not counted, so it is an upper bound.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "controller/mpc/ipopt/centroidal_nlp.h"
#include "controller/mpc/make_solver.h"
#include "controller/mpc/problem/ocp_json.h"

namespace sidestep::mpc {
namespace {

using Clock = std::chrono::steady_clock;

double MillisecondsSince(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

CentroidalOcp ReferenceProblem(const std::string& name) {
  const std::filesystem::path folder =
      std::filesystem::path(SIDESTEP_SOURCE_DIR) / "tests/data/reference";
  std::ifstream file(folder / (name + ".json"));
  return OcpFromJson(nlohmann::json::parse(file));
}

/// CPU time that the process has used so far.
double CpuTime_ms() { return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// CPU time of evaluating everything that one iteration needs, once.
double EvaluationTime_ms(const CentroidalOcp& ocp) {
  constexpr int kRepeats = 2000;
  CentroidalNlp nlp;
  nlp.SetProblem(ocp);
  const Eigen::VectorXd x = Eigen::VectorXd::Ones(nlp.num_variables());
  Eigen::VectorXd gradient(nlp.num_variables()), g(nlp.num_constraints());
  std::vector<double> jacobian(static_cast<std::size_t>(nlp.num_jacobian_entries()));
  std::vector<double> hessian(static_cast<std::size_t>(nlp.num_hessian_entries()));
  const double start_ms = CpuTime_ms();
  for (int i = 0; i < kRepeats; ++i) {
    benchmark::DoNotOptimize(nlp.Cost(x));
    nlp.Gradient(x, gradient);
    nlp.Constraints(x, g);
    nlp.JacobianValues(x, jacobian.data());
    nlp.HessianValues(x, 1.0, g, hessian.data());
    benchmark::ClobberMemory();
  }
  return (CpuTime_ms() - start_ms) / kRepeats;
}

double Percentile(const std::vector<double>& sorted, double fraction) {
  const auto last = static_cast<double>(sorted.size() - 1);
  return sorted[static_cast<std::size_t>(std::lround(fraction * last))];
}

/// A warm solve starts from the optimum of the same problem with the CoM 5 mm and its velocity
/// 2 cm/s elsewhere: about what a step of the closed loop leaves unforeseen.
CentroidalOcp Perturbed(CentroidalOcp ocp) {
  ocp.initial_p_WC += Eigen::Vector3d(0.005, -0.005, 0.002);
  ocp.initial_linear_momentum += ocp.mass_kg * Eigen::Vector3d(0.02, 0.02, -0.01);
  return ocp;
}

void Solve(benchmark::State& state, MpcBackend back_end, const std::string& name, bool is_warm) {
  const CentroidalOcp ocp = ReferenceProblem(name);
  const auto solver = MakeSolver(back_end, {});
  const MpcSolution guess = solver->Solve(Perturbed(ocp), nullptr);
  std::vector<double> times_ms;
  int iterations = 0;
  const double cpu_start_ms = CpuTime_ms();
  for (auto _ : state) {
    const Clock::time_point start = Clock::now();
    const MpcSolution& solution = solver->Solve(ocp, is_warm ? &guess : nullptr);
    times_ms.push_back(MillisecondsSince(start));
    iterations = solution.iterations;
    if (!IsUsable(solution.status)) {
      state.SkipWithError(EnumName(solution.status).data());
      return;
    }
  }
  const double cpu_ms = (CpuTime_ms() - cpu_start_ms) / static_cast<double>(times_ms.size());
  std::sort(times_ms.begin(), times_ms.end());
  state.counters["p50_ms"] = Percentile(times_ms, 0.5);
  state.counters["p99_ms"] = Percentile(times_ms, 0.99);
  state.counters["max_ms"] = times_ms.back();
  state.counters["iterations"] = iterations;
  state.counters["not_evaluation"] = 1.0 - iterations * EvaluationTime_ms(ocp) / cpu_ms;
}

#define SIDESTEP_MPC_BENCH(name)                                                          \
  BENCHMARK_CAPTURE(Solve, name##_ipopt_cold, MpcBackend::kIpopt, #name, false)           \
      ->Unit(benchmark::kMillisecond);                                                    \
  BENCHMARK_CAPTURE(Solve, name##_ipopt_warm, MpcBackend::kIpopt, #name, true)            \
      ->Unit(benchmark::kMillisecond);                                                    \
  BENCHMARK_CAPTURE(Solve, name##_structured_cold, MpcBackend::kStructured, #name, false) \
      ->Unit(benchmark::kMillisecond);                                                    \
  BENCHMARK_CAPTURE(Solve, name##_structured_warm, MpcBackend::kStructured, #name, true)  \
      ->Unit(benchmark::kMillisecond)

SIDESTEP_MPC_BENCH(hopper_pushed_5N_lateral);
SIDESTEP_MPC_BENCH(biped_walk_pushed_forward_5N);
SIDESTEP_MPC_BENCH(icub_lateral_40N_double_support);
SIDESTEP_MPC_BENCH(icub_N30_friction_1);

// Debian's MUMPS calls OpenMP when left to itself; more than one thread slows these sizes down.
[[maybe_unused]] const int one_thread = setenv("OMP_NUM_THREADS", "1", 1);

}  // namespace
}  // namespace sidestep::mpc
