// SPDX-License-Identifier: BSD-3-Clause
// Prints how near the structured back end is to what the core could do: floating-point operations
// of a factorisation, counted loop by loop as the code makes them, over the time of an iteration;
// beside it what the same core reaches in a loop of nothing but fused multiply-adds.
//
//   build/bench/tests/bench/mpc_floor_bench
//
// An iteration factorises once, twice where the inertia must be corrected; its evaluations and
// solves are not counted, so that the share is a lower bound.
#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "controller/mpc/make_solver.h"
#include "controller/mpc/structured/minimize.h"
#include "controller/mpc/structured/structured_problem.h"
#include "tests/bench/mpc_table_support.h"
#include "tests/support/recorded_problems.h"

namespace sidestep::mpc {
namespace {

constexpr int kRepeats = 50;
constexpr double kTileFlops = 4.0 * 4.0 * 2.0;  // of one pivot on four rows of four columns
constexpr double kSolveFlops = 4.0 * (4.0 + 6.0 * 2.0);  // of four rows below a head of four
constexpr double kStateDepth = 9.0;                      // of products with the state's rows
constexpr double kForceDepth = 6.0;                      // forces do not move p at once
constexpr double kValuePacks = 3.0;                      // columns of V_xx, in fours

// Pivots [.., end) on tiles of rows [begin, num_rows) and the four columns at `column`: a pivot
// counts where neither has structural zeros.
double UpdateFlops(const structured::Stage& stage, int column, int row_begin, int end) {
  double flops = 0.0;
  for (int row = row_begin; row < stage.num_rows; row += 4) {
    const int first = std::max(stage.first_pivot[row / 4], stage.first_pivot[column / 4]);
    flops += kTileFlops * std::max(0, end - first);
  }
  return flops;
}

double EliminationFlops(const structured::Stage& stage) {
  double flops = 0.0;
  for (int column = 0; column < stage.num_rows; column += 4) {
    const int end = std::min(column, stage.num_pivots);
    flops += UpdateFlops(stage, column, column, end);
    if (column >= stage.num_pivots) continue;
    for (int row = column + 4; row < stage.num_rows; row += 4) {
      if (stage.first_pivot[row / 4] <= column) flops += kSolveFlops;
    }
  }
  return flops;
}

// G' V_xx G + G' Y' + Y G, and the product G' V_xx before it.
double CongruenceFlops(const structured::Stage& stage) {
  const double packs = stage.num_active / 4.0;
  double flops = kValuePacks * packs * kStateDepth * kTileFlops;
  for (int column = 0; column < stage.num_active; column += 4) {
    const double below = (stage.num_active - column) / 4.0;
    const bool is_force = column + 4 <= 3 * stage.num_slots;
    const double depth = (is_force ? kForceDepth : kStateDepth) + kStateDepth;
    flops += below * depth * kTileFlops;
  }
  return flops;
}

double FactorisationFlops(const CentroidalOcp& ocp) {
  structured::StructuredProblem problem;
  problem.Build(ocp);
  double flops = 0.0;
  for (int k = 0; k <= ocp.knots; ++k) {
    const structured::Stage& stage = problem.view().stages[k];
    flops += EliminationFlops(stage) + (k < ocp.knots ? CongruenceFlops(stage) : 0.0);
  }
  return flops;
}

// Twelve independent sums, as many as the products' tiles have.
#if defined(__x86_64__)
__attribute__((target("avx2,fma"))) double PeakGflops() {
  using Pack = double __attribute__((vector_size(32)));
  constexpr int kSums = 12, kRounds = 2000000;
  Pack sums[kSums];
  // Each begins elsewhere: of equal sums the compiler makes one.
  for (int i = 0; i < kSums; ++i) sums[i] = Pack{1.0, 2.0, 3.0, 4.0} * (i + 1.0);
  const Pack factor{1.0 + 1e-9, 1.0 - 1e-9, 1.0, 1.0}, term{1e-9, 1e-9, 1e-9, 1e-9};
  const double start_ms = CpuTime_ms();
  for (int i = 0; i < kRounds; ++i) {
#pragma GCC unroll 12
    for (Pack& sum : sums) sum = sum * factor + term;
  }
  const double elapsed_ms = CpuTime_ms() - start_ms;
  double check = 0.0;
  for (const Pack& sum : sums) check += sum[0] + sum[1] + sum[2] + sum[3];
  return check == 0.0 ? 0.0 : 8.0 * kSums * kRounds / elapsed_ms * 1e-6;
}
#else
double PeakGflops() { return 0.0; }
#endif

struct Figures {
  int iterations{0};
  double iteration_us{0.0}, flops{0.0}, peak_Gflops{0.0};
};

// The peak is measured between solves: a machine's clock may wander.
Figures Measure(const CentroidalOcp& ocp, CentroidalSolver* solver) {
  std::vector<double> times_us, peaks;
  Figures figures;
  for (int i = 0; i < kRepeats; ++i) {
    Timings timings;
    const MpcSolution answer = TimedSolve(*solver, ocp, nullptr, 1, &timings);
    figures.iterations = answer.iterations;
    times_us.push_back(1e3 * timings.times_ms.front() / std::max(1, answer.iterations));
    if (i % 10 == 0) peaks.push_back(structured::HasFastInstructions() ? PeakGflops() : 0.0);
  }
  figures.iteration_us = Quantile(times_us, 0.5);
  figures.peak_Gflops = Quantile(peaks, 0.5);
  figures.flops = FactorisationFlops(ocp);
  return figures;
}

int Main() {
  std::printf("instructions: %s\n\n", structured::HasFastInstructions() ? "AVX2, FMA" : "baseline");
  std::printf(
      "| problem | iterations | us an iteration | kflop a factorisation | GFlop/s | FMA loop, "
      "GFlop/s | share |\n| --- | --: | --: | --: | --: | --: | --: |\n");
  const auto solver = MakeSolver(MpcBackend::kStructured, {});
  for (const std::string& folder : RecordedFolders()) {
    const CentroidalOcp ocp = ReadProblem(ProblemFiles(RecordedFolder() / folder).front());
    const Figures f = Measure(ocp, solver.get());
    const double rate_Gflops = f.flops / f.iteration_us * 1e-3;
    std::printf("| `%s` | %d | %.0f | %.0f | %.1f | %.1f | %.0f %% |\n", folder.c_str(),
                f.iterations, f.iteration_us, 1e-3 * f.flops, rate_Gflops, f.peak_Gflops,
                f.peak_Gflops > 0.0 ? 100.0 * rate_Gflops / f.peak_Gflops : 0.0);
  }
  return 0;
}

}  // namespace
}  // namespace sidestep::mpc

int main() { return sidestep::mpc::Main(); }
