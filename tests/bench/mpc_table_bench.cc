// SPDX-License-Identifier: BSD-3-Clause
// Prints the table that compares the MPC's back ends: both solve the same problems from the same
// starts, one after the other, in one run. CPU times of the one thread:
//
//   OMP_NUM_THREADS=1 nice build/bench/tests/bench/mpc_table_bench
//
// `sequences` are consecutive problems of closed-loop runs (tests/data/mpc): cold, and warm from
// Ipopt's answer to the one before, shifted. `reference` are the problems of tests/data/reference,
// cold. Ratios are Ipopt's time over the structured back end's. Cost, force and place compare each
// answer with Ipopt's: relative, of body weight, in m; where the costs differ by more than 1e-6 the
// two fell into other local minima, which counts as `other` and leaves force and place out.
// `readme` is `sequences` in fewer columns: a row a folder, warm as in the loop.
#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "controller/mpc/make_solver.h"
#include "controller/mpc/shifted_guess.h"
#include "tests/bench/mpc_table_support.h"
#include "tests/support/recorded_problems.h"
#include "tests/support/solution_difference.h"

namespace sidestep::mpc {
namespace {

namespace fs = std::filesystem;

constexpr int kRepeats = 10;  // Of the structured back end: it needs more to time than to wait for.

struct Row {
  std::string name;
  Timings ipopt, structured;
  double worst_cost{0.0}, worst_force{0.0}, worst_place_m{0.0};
  int num_other_minima{0};
};

class BackEnds {
 public:
  /// Solves with both; returns Ipopt's answer.
  MpcSolution Solve(const CentroidalOcp& ocp, const MpcSolution* guess, Row* row) {
    MpcSolution theirs = TimedSolve(*ipopt_, ocp, guess, 1, &row->ipopt);
    const MpcSolution ours = TimedSolve(*structured_, ocp, guess, kRepeats, &row->structured);
    if (!IsUsable(theirs.status) || !IsUsable(ours.status)) return theirs;
    const Difference difference = Compare(ocp, theirs, ours);
    if (difference.is_other_minimum()) {
      ++row->num_other_minima;
    } else {
      row->worst_force = std::max(row->worst_force, difference.force);
      row->worst_place_m = std::max(row->worst_place_m, difference.place_m);
    }
    row->worst_cost = std::max(row->worst_cost, difference.cost);
    return theirs;
  }

 private:
  std::unique_ptr<CentroidalSolver> ipopt_{MakeSolver(MpcBackend::kIpopt, {})};
  std::unique_ptr<CentroidalSolver> structured_{MakeSolver(MpcBackend::kStructured, {})};
};

double P50(const Timings& timings) { return Quantile(timings.times_ms, 0.50); }
double P99(const Timings& timings) { return Quantile(timings.times_ms, 0.99); }

void EndLine(const Row& row) {
  if (row.ipopt.num_failures + row.structured.num_failures > 0) {
    std::printf(" unsolved: Ipopt %d, structured %d", row.ipopt.num_failures,
                row.structured.num_failures);
  }
  std::printf("\n");
  std::fflush(stdout);
}

void PrintHeader() {
  std::printf(
      "| problem | Ipopt p50 / p99 / max ms | it. | structured p50 / p99 / max ms | it. p50 / max "
      "| worst KKT | ratio p50 / p99 | cost | force | place m | other |\n"
      "|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n");
}

void Print(const Row& row) {
  const Timings& a = row.ipopt;
  const Timings& b = row.structured;
  std::printf(
      "| %s | %.1f / %.1f / %.1f | %.0f | %.2f / %.2f / %.2f | %.0f / %.0f | %.0e | %.0f / %.0f "
      "| %+.0e | %.0e | %.0e | %d |",
      row.name.c_str(), P50(a), P99(a), Quantile(a.times_ms, 1.0), Quantile(a.iterations, 0.5),
      P50(b), P99(b), Quantile(b.times_ms, 1.0), Quantile(b.iterations, 0.5),
      Quantile(b.iterations, 1.0), b.worst_kkt, P50(a) / P50(b), P99(a) / P99(b), row.worst_cost,
      row.worst_force, row.worst_place_m, row.num_other_minima);
  EndLine(row);
}

/// One folder's problems.
struct Sequence {
  std::string size;  ///< Knots x contacts x vertices of the contact with most.
  Row cold, warm;
};

std::string Size(const CentroidalOcp& ocp) {
  Eigen::Index vertices = 0;
  for (const OcpContact& contact : ocp.contacts) {
    vertices = std::max(vertices, contact.vertices_m.cols());
  }
  return std::to_string(ocp.knots) + " x " + std::to_string(ocp.contacts.size()) + " x " +
         std::to_string(vertices);
}

Sequence SolveSequence(const std::string& folder, BackEnds* back_ends) {
  Sequence sequence;
  sequence.cold.name = folder + ", cold";
  sequence.warm.name = folder + ", warm";
  CentroidalOcp before;
  MpcSolution answer;
  for (const fs::path& path : ProblemFiles(RecordedFolder() / folder)) {
    const CentroidalOcp ocp = ReadProblem(path);
    MpcSolution guess;
    if (before.knots == ocp.knots && !before.contacts.empty()) {
      ShiftedGuess(before, answer, 1, ocp, &guess);
      back_ends->Solve(ocp, &guess, &sequence.warm);
    }
    answer = back_ends->Solve(ocp, nullptr, &sequence.cold);
    before = ocp;
  }
  sequence.size = Size(before);
  return sequence;
}

void AddSequences(BackEnds* back_ends) {
  for (const std::string& folder : RecordedFolders()) {
    const Sequence sequence = SolveSequence(folder, back_ends);
    Print(sequence.cold);
    Print(sequence.warm);
  }
}

void PrintForReadme(BackEnds* back_ends) {
  std::printf(
      "| problem | knots x contacts x vertices | Ipopt p50 / p99 ms | structured p50 / p99 ms "
      "| iterations | ratio p50 | ratio p99 | cold ratio p50 |\n"
      "|---|---|--:|--:|--:|--:|--:|--:|\n");
  for (const std::string& folder : RecordedFolders()) {
    const Sequence sequence = SolveSequence(folder, back_ends);
    const Timings& a = sequence.warm.ipopt;
    const Timings& b = sequence.warm.structured;
    std::printf("| `%s` | %s | %.0f / %.0f | %.1f / %.1f | %.0f / %.0f | %.0f | %.0f | %.0f |",
                folder.c_str(), sequence.size.c_str(), P50(a), P99(a), P50(b), P99(b),
                Quantile(a.iterations, 0.5), Quantile(b.iterations, 0.5), P50(a) / P50(b),
                P99(a) / P99(b), P50(sequence.cold.ipopt) / P50(sequence.cold.structured));
    EndLine(sequence.warm);
  }
}

void AddReference(BackEnds* back_ends) {
  for (const fs::path& path : ProblemFiles(ReferenceFolder())) {
    Row row;
    row.name = path.stem().string();
    back_ends->Solve(ReadProblem(path), nullptr, &row);
    Print(row);
  }
}

void AddScaling(BackEnds* back_ends) {
  for (const int knots : {15, 30, 60, 120}) {
    Row row;
    row.name = "walk on two feet of 4, N = " + std::to_string(knots);
    back_ends->Solve(WalkingProblem(knots, 2, 4), nullptr, &row);
    Print(row);
  }
  for (const int feet : {1, 2, 4}) {
    for (const int vertices : {1, 4}) {
      Row row;
      row.name = std::to_string(feet) + " feet of " + std::to_string(vertices) + ", N = 15";
      back_ends->Solve(WalkingProblem(15, feet, vertices), nullptr, &row);
      Print(row);
    }
  }
}

int Main(int argc, char** argv) {
  setenv("OMP_NUM_THREADS", "1", 1);  // Before Ipopt's first use: MUMPS is slower on more.
  BackEnds back_ends;
  if (argc > 1 && std::string(argv[1]) == "readme") {
    PrintForReadme(&back_ends);
    return 0;
  }
  PrintHeader();
  for (int i = 1; i < std::max(argc, 2); ++i) {
    const std::string what = argc > 1 ? argv[i] : "all";
    if (what == "sequences" || what == "all") AddSequences(&back_ends);
    if (what == "reference" || what == "all") AddReference(&back_ends);
    if (what == "scaling" || what == "all") AddScaling(&back_ends);
  }
  return 0;
}

}  // namespace
}  // namespace sidestep::mpc

int main(int argc, char** argv) { return sidestep::mpc::Main(argc, argv); }
