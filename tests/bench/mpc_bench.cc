// SPDX-License-Identifier: BSD-3-Clause
// Time to solve one MPC problem, cold and warm, on reference problems. Counters: percentiles of the
// solve time over all solves of a case, iterations, and the share of the time that is not spent in
// evaluating the problem.
//
// That share is 1 - iterations * (one evaluation of cost, gradient, constraints, Jacobian and
// Hessian) / (time of a solve): Ipopt's own timing statistics are out of reach behind the solver
// interface, and what is not evaluation is factorisation, MUMPS's bookkeeping and Ipopt's vectors.
// Line searches that need a second trial point are not counted, so it is an upper bound.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "controller/mpc/centroidal_nlp.h"
#include "controller/mpc/centroidal_solver.h"
#include "controller/mpc/ocp_json.h"

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

/// Time of evaluating everything that one iteration needs, once.
double EvaluationTime_ms(const CentroidalOcp& ocp) {
  constexpr int kRepeats = 200;
  CentroidalNlp nlp;
  nlp.SetProblem(ocp);
  const Eigen::VectorXd x = Eigen::VectorXd::Ones(nlp.num_variables());
  Eigen::VectorXd gradient(nlp.num_variables()), g(nlp.num_constraints());
  std::vector<double> jacobian(static_cast<std::size_t>(nlp.num_jacobian_entries()));
  std::vector<double> hessian(static_cast<std::size_t>(nlp.num_hessian_entries()));
  const Clock::time_point start = Clock::now();
  for (int i = 0; i < kRepeats; ++i) {
    benchmark::DoNotOptimize(nlp.Cost(x));
    nlp.Gradient(x, gradient);
    nlp.Constraints(x, g);
    nlp.JacobianValues(x, jacobian.data());
    nlp.HessianValues(1.0, g, hessian.data());
    benchmark::ClobberMemory();
  }
  return MillisecondsSince(start) / kRepeats;
}

double Percentile(const std::vector<double>& sorted, double fraction) {
  const auto last = static_cast<double>(sorted.size() - 1);
  return sorted[static_cast<std::size_t>(fraction * last + 0.5)];
}

/// A warm solve starts from the optimum of the same problem with the CoM 5 mm and its velocity
/// 2 cm/s elsewhere: about what a step of the closed loop leaves unforeseen.
CentroidalOcp Perturbed(CentroidalOcp ocp) {
  ocp.initial_p_WC += Eigen::Vector3d(0.005, -0.005, 0.002);
  ocp.initial_linear_momentum += ocp.mass_kg * Eigen::Vector3d(0.02, 0.02, -0.01);
  return ocp;
}

void Solve(benchmark::State& state, const std::string& name, bool is_warm) {
  const CentroidalOcp ocp = ReferenceProblem(name);
  const auto solver = MakeSolver("ipopt", {});
  const MpcSolution guess = solver->Solve(Perturbed(ocp), nullptr);
  std::vector<double> times_ms;
  int iterations = 0;
  for (auto _ : state) {
    const Clock::time_point start = Clock::now();
    const MpcSolution& solution = solver->Solve(ocp, is_warm ? &guess : nullptr);
    times_ms.push_back(MillisecondsSince(start));
    iterations = solution.iterations;
    if (!IsUsable(solution.status)) {
      state.SkipWithError(ToString(solution.status));
      return;
    }
  }
  std::sort(times_ms.begin(), times_ms.end());
  const double median_ms = Percentile(times_ms, 0.5);
  state.counters["p50_ms"] = median_ms;
  state.counters["p99_ms"] = Percentile(times_ms, 0.99);
  state.counters["max_ms"] = times_ms.back();
  state.counters["iterations"] = iterations;
  state.counters["not_evaluation"] = 1.0 - iterations * EvaluationTime_ms(ocp) / median_ms;
}

#define SIDESTEP_MPC_BENCH(name)                                                      \
  BENCHMARK_CAPTURE(Solve, name##_cold, #name, false)->Unit(benchmark::kMillisecond); \
  BENCHMARK_CAPTURE(Solve, name##_warm, #name, true)->Unit(benchmark::kMillisecond)

SIDESTEP_MPC_BENCH(hopper_pushed_5N_lateral);
SIDESTEP_MPC_BENCH(biped_walk_pushed_forward_5N);
SIDESTEP_MPC_BENCH(icub_lateral_40N_double_support);
SIDESTEP_MPC_BENCH(icub_N30_friction_1);

// Debian's MUMPS calls OpenMP when left to itself; more than one thread slows these sizes down.
[[maybe_unused]] const int one_thread = setenv("OMP_NUM_THREADS", "1", 1);

}  // namespace
}  // namespace sidestep::mpc
