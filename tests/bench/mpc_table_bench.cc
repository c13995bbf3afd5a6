// SPDX-License-Identifier: BSD-3-Clause
// Prints the table that compares the MPC's back ends: both solve the same problems from the same
// starts, one after the other, in one run. CPU times of the one thread:
//
//   OMP_NUM_THREADS=1 nice build/release/tests/bench/mpc_table_bench
//
// `sequences` are consecutive problems of closed-loop runs (tests/data/mpc): cold, and warm from
// Ipopt's answer to the one before, shifted. `reference` are the problems of tests/data/reference,
// cold. Ratios are Ipopt's time over the structured back end's. Cost, force and place compare each
// answer with Ipopt's: relative, of body weight, in m; where the costs differ by more than 1e-6 the
// two fell into other local minima, which counts as `other` and leaves force and place out.
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "controller/mpc/ocp_json.h"
#include "controller/mpc/shifted_guess.h"
#include "tests/bench/mpc_table_support.h"

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

class Table {
 public:
  Table() : ipopt_(MakeSolver("ipopt", {})), structured_(MakeSolver("structured", {})) {
    std::printf(
        "| problem | Ipopt p50 / p99 / max ms | it. | structured p50 / p99 / max ms | it. p50 / "
        "max "
        "| worst KKT | ratio p50 / p99 | cost | force | place m | other |\n"
        "|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n");
  }

  /// Solves with both; returns Ipopt's answer.
  MpcSolution Add(const CentroidalOcp& ocp, const MpcSolution* guess, Row* row) {
    const MpcSolution theirs = TimedSolve(*ipopt_, ocp, guess, 1, &row->ipopt);
    const MpcSolution ours = TimedSolve(*structured_, ocp, guess, kRepeats, &row->structured);
    if (!IsUsable(theirs.status) || !IsUsable(ours.status)) return theirs;
    const Difference difference = Compare(ocp, theirs, ours);
    if (std::abs(difference.cost) > 1e-6) {
      ++row->num_other_minima;
    } else {
      row->worst_force = std::max(row->worst_force, difference.force);
      row->worst_place_m = std::max(row->worst_place_m, difference.place_m);
    }
    row->worst_cost = std::max(row->worst_cost, difference.cost);
    return theirs;
  }

  static void Print(const Row& row) {
    const Timings& a = row.ipopt;
    const Timings& b = row.structured;
    const auto p50 = [](const Timings& t) { return Quantile(t.times_ms, 0.5); };
    const auto p99 = [](const Timings& t) { return Quantile(t.times_ms, 0.99); };
    std::printf(
        "| %s | %.1f / %.1f / %.1f | %.0f | %.2f / %.2f / %.2f | %.0f / %.0f | %.0e | %.0f / %.0f "
        "| %+.0e | %.0e | %.0e | %d |",
        row.name.c_str(), p50(a), p99(a), Quantile(a.times_ms, 1.0), Quantile(a.iterations, 0.5),
        p50(b), p99(b), Quantile(b.times_ms, 1.0), Quantile(b.iterations, 0.5),
        Quantile(b.iterations, 1.0), b.worst_kkt, p50(a) / p50(b), p99(a) / p99(b), row.worst_cost,
        row.worst_force, row.worst_place_m, row.num_other_minima);
    if (a.num_failures + b.num_failures > 0) {
      std::printf(" unsolved: Ipopt %d, structured %d", a.num_failures, b.num_failures);
    }
    std::printf("\n");
    std::fflush(stdout);
  }

 private:
  std::unique_ptr<CentroidalSolver> ipopt_;
  std::unique_ptr<CentroidalSolver> structured_;
};

std::vector<fs::path> Sorted(const fs::path& folder) {
  std::vector<fs::path> paths;
  for (const auto& entry : fs::directory_iterator(folder)) paths.push_back(entry.path());
  std::sort(paths.begin(), paths.end());
  return paths;
}

CentroidalOcp Read(const fs::path& path) {
  std::ifstream file(path);
  return OcpFromJson(nlohmann::json::parse(file));
}

void AddSequences(Table* table) {
  for (const fs::path& folder : Sorted(fs::path(SIDESTEP_SOURCE_DIR) / "tests/data/mpc")) {
    if (!fs::is_directory(folder)) continue;
    Row cold, warm;
    cold.name = folder.filename().string() + ", cold";
    warm.name = folder.filename().string() + ", warm";
    CentroidalOcp before;
    MpcSolution answer;
    for (const fs::path& path : Sorted(folder)) {
      const CentroidalOcp ocp = Read(path);
      MpcSolution guess;
      if (before.knots == ocp.knots && !before.contacts.empty()) {
        ShiftedGuess(before, answer, 1, ocp, &guess);
        table->Add(ocp, &guess, &warm);
      }
      answer = table->Add(ocp, nullptr, &cold);
      before = ocp;
    }
    Table::Print(cold);
    Table::Print(warm);
  }
}

void AddReference(Table* table) {
  for (const fs::path& path : Sorted(ReferenceFolder())) {
    if (path.extension() != ".json") continue;
    Row row;
    row.name = path.stem().string();
    table->Add(Read(path), nullptr, &row);
    Table::Print(row);
  }
}

void AddScaling(Table* table) {
  for (const int knots : {15, 30, 60, 120}) {
    Row row;
    row.name = "walk on two feet of 4, N = " + std::to_string(knots);
    table->Add(WalkingProblem(knots, 2, 4), nullptr, &row);
    Table::Print(row);
  }
  for (const int feet : {1, 2, 4}) {
    for (const int vertices : {1, 4}) {
      Row row;
      row.name = std::to_string(feet) + " feet of " + std::to_string(vertices) + ", N = 15";
      table->Add(WalkingProblem(15, feet, vertices), nullptr, &row);
      Table::Print(row);
    }
  }
}

int Main(int argc, char** argv) {
  setenv("OMP_NUM_THREADS", "1", 1);  // Before Ipopt's first use: MUMPS is slower on more.
  Table table;
  for (int i = 1; i < std::max(argc, 2); ++i) {
    const std::string what = argc > 1 ? argv[i] : "all";
    if (what == "sequences" || what == "all") AddSequences(&table);
    if (what == "reference" || what == "all") AddReference(&table);
    if (what == "scaling" || what == "all") AddScaling(&table);
  }
  return 0;
}

}  // namespace
}  // namespace sidestep::mpc

int main(int argc, char** argv) { return sidestep::mpc::Main(argc, argv); }
