// SPDX-License-Identifier: BSD-3-Clause
// A control tick takes no memory once every size has been seen. Ticks on which the MPC solves are
// left out: Ipopt allocates as it pleases, and a new plan is copied into its slot.
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <vector>

#include "tests/support/allocation_counter.h"
#include "tests/support/hopper_scenario.h"
#include "tests/support/watched_controller.h"

namespace sidestep::control_tick_allocation_test {
namespace {

// Standing, first stance, flight and landing: every shape of the whole-body problem occurs.
constexpr double kWarmUp_s = 1.0;
constexpr double kCounted_s = 0.4;  // a whole hop of 0.3 s

TEST(ControlTickAllocationTest, TheCounterSeesEigenAndTheStandardLibrary) {
  // Volatile pointers keep the compiler from leaving the allocations out.
  std::int64_t before = CountAllocations();
  const Eigen::VectorXd vector = Eigen::VectorXd::Zero(100);
  const double* volatile data = vector.data();
  EXPECT_EQ(CountAllocations() - before, 1) << data;
  before = CountAllocations();
  const std::vector<double> values(100);
  data = values.data();
  EXPECT_EQ(CountAllocations() - before, 1) << data;
}

void ExpectNoAllocation(const Scenario& scenario) {
  int counted = 0, in_stance = 0;
  RunWatched(scenario, kWarmUp_s + kCounted_s,
             [&](const SensorFrame& frame, Controller* controller,
                 const WorldTruth&) -> const ControlTick& {
               const Tick tick = frame.tick;
               const std::int64_t before = CountAllocations();
               const ControlTick& control = controller->Update(frame);
               const std::int64_t taken = CountAllocations() - before;
               const bool is_warm = SecondsAt(tick, scenario.world.step_s) >= kWarmUp_s;
               if (is_warm && !control.mpc.ran) {
                 EXPECT_EQ(taken, 0) << "at tick " << tick;
                 ++counted;
                 in_stance += control.feet[0].planned_contact ? 1 : 0;
               }
               return control;
             });
  EXPECT_GT(counted, 100);
  EXPECT_GT(in_stance, 50);
  EXPECT_GT(counted - in_stance, 50) << "stance and flight";
}

TEST(ControlTickAllocationTest, TickWithoutSolveTakesNoMemoryOnSensors) {
  ExpectNoAllocation(HoppingHopper());
}

TEST(ControlTickAllocationTest, TickWithoutSolveTakesNoMemoryOnTruthWithAKnownPushAndLatency) {
  Scenario scenario = HoppingHopper(
      {"control.estimator=truth", "control.external_wrench=known", "control.mpc.latency_s=0.02"});
  scenario.pushes = {TrunkPush({1.0, 0.5, 0.0}, 1.1, 0.1, kTrunkCom_m)};
  ExpectNoAllocation(scenario);
}

}  // namespace
}  // namespace sidestep::control_tick_allocation_test
