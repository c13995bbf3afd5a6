// SPDX-License-Identifier: BSD-3-Clause
// The structured back end takes no memory once it has met its largest problem.
#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

#include "controller/mpc/centroidal_solver.h"
#include "controller/mpc/shifted_guess.h"
#include "tests/unit/mpc/mpc_test_support.h"

namespace {
long num_allocations = 0;
}  // namespace

extern "C" {
#ifdef __SANITIZE_ADDRESS__
// AddressSanitizer owns malloc and calls this at each allocation.
void __sanitizer_malloc_hook(const volatile void*, std::size_t) { ++num_allocations; }
void __sanitizer_free_hook(const volatile void*) {}
#else
void* __libc_malloc(std::size_t size);  // glibc's own, under the name it keeps for this use.
void* malloc(std::size_t size) noexcept {
  ++num_allocations;
  return __libc_malloc(size);
}
#endif
}

namespace sidestep::mpc {
namespace {

TEST(StructuredStorageTest, AHundredConsecutiveSolvesOfChangingSchedulesAllocateNothing) {
  // Prepared beforehand: a walk followed for 25 steps, whose contacts come and go.
  const auto solver = MakeSolver("structured", {});
  std::vector<CentroidalOcp> problems{ReferenceProblem("biped_walk_double_support")};
  std::vector<MpcSolution> solutions;
  for (int step = 0; step < 24; ++step) {
    solutions.push_back(solver->Solve(problems.back(), nullptr));
    ASSERT_TRUE(IsUsable(solutions.back().status)) << step;
    problems.push_back(AdvanceProblem(problems.back(), solutions.back()));
  }
  solutions.push_back(solver->Solve(problems.back(), nullptr));
  std::vector<MpcSolution> guesses(problems.size());
  for (std::size_t i = 1; i < problems.size(); ++i) {
    ShiftedGuess(problems[i - 1], solutions[i - 1], 1, problems[i], &guesses[i]);
  }
  const auto fresh = MakeSolver("structured", {});
  // The answer's own list of phases may grow by one within the first schedules.
  for (const CentroidalOcp& ocp : problems) fresh->Solve(ocp, nullptr);
  const long before = num_allocations;
  int num_usable = 0;
  for (int round = 0; round < 2; ++round) {
    for (std::size_t i = 0; i < problems.size(); ++i) {
      num_usable += IsUsable(fresh->Solve(problems[i], nullptr).status) ? 1 : 0;
      const MpcSolution* guess = i == 0 ? nullptr : &guesses[i];
      num_usable += IsUsable(fresh->Solve(problems[i], guess).status) ? 1 : 0;
    }
  }
  EXPECT_EQ(num_allocations, before);
  EXPECT_EQ(num_usable, 100);
}

}  // namespace
}  // namespace sidestep::mpc
