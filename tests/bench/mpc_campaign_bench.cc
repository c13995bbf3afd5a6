// SPDX-License-Identifier: BSD-3-Clause
// Random problems in number (tests/unit/mpc/random_ocp.h): does the structured back end end every
// one with a status and finite numbers, and do its statuses agree with Ipopt's?
//
//   OMP_NUM_THREADS=1 mpc_campaign_bench FIRST END [structured]
//
// solves seeds FIRST <= seed < END; `structured` leaves Ipopt out. Prints each disagreement and a
// summary; exits with 1 if a number is not finite, a status is neither solved nor infeasible, or
// less than 99.5 % of the statuses agree.
#include <cstdio>
#include <cstdlib>

#include "controller/mpc/make_solver.h"
#include "controller/mpc/problem/solution_shape.h"
#include "tests/bench/mpc_table_support.h"
#include "tests/unit/mpc/random_ocp.h"

namespace sidestep::mpc {
namespace {

struct Counts {
  int num_problems{0}, num_compared{0}, num_agreeing{0}, num_broken{0}, num_infeasible{0};
  int num_higher{0}, num_lower{0};
};

void CompareWithIpopt(unsigned seed, const CentroidalOcp& ocp, const MpcSolution& ours,
                      CentroidalSolver& ipopt, Counts* counts) {
  const MpcSolution& theirs = ipopt.Solve(ocp, nullptr);
  ++counts->num_compared;
  if (IsUsable(ours.status) == IsUsable(theirs.status)) {
    ++counts->num_agreeing;
  } else {
    std::printf("seed %u: structured %s, Ipopt %s after %d iterations\n", seed,
                EnumName(ours.status).data(), EnumName(theirs.status).data(), theirs.iterations);
  }
  if (!IsUsable(ours.status) || !IsUsable(theirs.status)) return;
  counts->num_higher += ours.cost > theirs.cost * (1.0 + 1e-6) ? 1 : 0;
  counts->num_lower += ours.cost < theirs.cost * (1.0 - 1e-6) ? 1 : 0;
}

int Main(int argc, char** argv) {
  if (argc < 3) {
    std::fprintf(stderr, "usage: %s FIRST END [structured]\n", argv[0]);
    return 2;
  }
  const auto first = static_cast<unsigned>(std::strtoul(argv[1], nullptr, 10));
  const auto end = static_cast<unsigned>(std::strtoul(argv[2], nullptr, 10));
  const bool with_ipopt = argc == 3;
  const auto structured = MakeSolver(MpcBackend::kStructured, {});
  const auto ipopt = MakeSolver(MpcBackend::kIpopt, {});
  Counts counts;
  Timings timings;
  for (unsigned seed = first; seed < end; ++seed) {
    const CentroidalOcp ocp = RandomOcp(seed);
    const MpcSolution ours = TimedSolve(*structured, ocp, nullptr, 1, &timings);
    ++counts.num_problems;
    const bool is_infeasible = ours.status == SolveStatus::kInfeasible;
    counts.num_infeasible += is_infeasible ? 1 : 0;
    if (!IsFinite(ours) || (!IsUsable(ours.status) && !is_infeasible)) {
      ++counts.num_broken;
      std::printf("seed %u: structured %s\n", seed, EnumName(ours.status).data());
    }
    if (with_ipopt) CompareWithIpopt(seed, ocp, ours, *ipopt, &counts);
  }
  std::printf(
      "%d problems, %d infeasible, %d without an answer; iterations p50 %.0f, p99 %.0f, max "
      "%.0f; worst KKT %.1e\n",
      counts.num_problems, counts.num_infeasible, counts.num_broken,
      Quantile(timings.iterations, 0.5), Quantile(timings.iterations, 0.99),
      Quantile(timings.iterations, 1.0), timings.worst_kkt);
  if (with_ipopt) {
    std::printf("statuses agree with Ipopt's on %d of %d; cost higher on %d, lower on %d\n",
                counts.num_agreeing, counts.num_compared, counts.num_higher, counts.num_lower);
  }
  return counts.num_broken > 0 || 1000 * counts.num_agreeing < 995 * counts.num_compared ? 1 : 0;
}

}  // namespace
}  // namespace sidestep::mpc

int main(int argc, char** argv) { return sidestep::mpc::Main(argc, argv); }
