// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// mpc_table_support: problems, clocks and sums for the table of the MPC's back ends.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <ctime>
#include <string>
#include <vector>

#include "controller/mpc/problem/centroidal_solver.h"
#include "tests/unit/mpc/mpc_test_support.h"

namespace sidestep::mpc {

/// Solves of one back end.
struct Timings {
  std::vector<double> times_ms;
  std::vector<int> iterations;
  double worst_kkt{0.0};
  int num_failures{0};
};

/// Value below which a share `q` of the samples lies (nearest rank); 0 without samples.
template <typename T>
double Quantile(std::vector<T> samples, double q) {
  if (samples.empty()) return 0.0;
  std::sort(samples.begin(), samples.end());
  const double rank = std::ceil(q * static_cast<double>(samples.size())) - 1.0;
  return static_cast<double>(samples[static_cast<std::size_t>(std::max(0.0, rank))]);
}

/// CPU time of this thread, ms. Both solvers are single-threaded: unlike wall time it leaves out
/// what other processes take, so that ratios hold on a busy machine too.
inline double CpuTime_ms() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

/// Solves `repeats` times in a row, every one a sample; returns the answer.
inline MpcSolution TimedSolve(CentroidalSolver& solver, const CentroidalOcp& ocp,
                              const MpcSolution* guess, int repeats, Timings* timings) {
  MpcSolution answer;
  for (int i = 0; i < repeats; ++i) {
    const double start_ms = CpuTime_ms();
    const MpcSolution& solution = solver.Solve(ocp, guess);
    timings->times_ms.push_back(CpuTime_ms() - start_ms);
    answer = solution;
  }
  timings->iterations.push_back(answer.iterations);
  timings->num_failures += IsUsable(answer.status) ? 0 : 1;
  if (IsUsable(answer.status)) timings->worst_kkt = std::max(timings->worst_kkt, answer.kkt_error);
  return answer;
}

/// A robot of 30 kg that walks forward on `feet` feet with `vertices` vertices each; stances of
/// eight knots, swings of four, evenly staggered.
inline CentroidalOcp WalkingProblem(int knots, int feet, int vertices) {
  constexpr int kStance = 8, kPeriod = 12;
  constexpr double kSpeed_mps = 0.1;
  CentroidalOcp ocp = FloatingProblem(knots);
  ocp.mass_kg = 30.0;
  ocp.initial_p_WC << 0.0, 0.01, 0.55;
  ocp.initial_linear_momentum << 3.0, 1.0, 0.0;
  for (int k = 0; k <= knots; ++k) ocp.reference_p_WC.col(k) << 0.1 * kSpeed_mps * k, 0.0, 0.55;
  for (int i = 0; i < feet; ++i) {
    OcpContact foot = Foot("foot", vertices);
    const double side_m = i % 2 == 0 ? 0.1 : -0.1;
    const double ahead_m = feet > 2 ? (i < 2 ? 0.2 : -0.2) : 0.0;
    for (int first = i * kPeriod / feet - kPeriod - 4; first <= knots; first += kPeriod) {
      const int end = first + kStance;
      if (end <= 0) continue;
      const Eigen::Vector3d place(ahead_m + 0.1 * kSpeed_mps * std::max(0, first), side_m, 0.0);
      foot.phases.push_back(first <= 0 ? FixedPhase(0, end, place)
                                       : FreePhase(first, end, place, {0.1, 0.1, 0.0}));
    }
    ocp.contacts.push_back(foot);
  }
  return ocp;
}

}  // namespace sidestep::mpc
