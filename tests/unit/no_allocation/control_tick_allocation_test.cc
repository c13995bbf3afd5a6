// SPDX-License-Identifier: BSD-3-Clause
// A control tick takes no memory once every size has been seen. Ticks on which the MPC solves are
// left out: Ipopt allocates as it pleases, and a new plan is copied into its slot.
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <vector>

#include "controller/locomotion_controller.h"
#include "sim/sensors/sensor_suite.h"
#include "sim/world/mujoco_world.h"
#include "tests/support/allocation_counter.h"
#include "tests/support/hopper_scenario.h"

namespace sidestep {
namespace {

// Standing, first stance, flight and landing: every shape of the whole-body problem occurs.
constexpr Tick kWarmUp = 1000;
constexpr Tick kCounted = 400;  // a whole hop of 300 ticks, at 50 ticks a solve

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
  MujocoWorld world(scenario);
  SensorSuite sensors(scenario, world.mass_kg());
  StageTimer timer;
  LocomotionController controller({scenario.description_of_robot, scenario.control, scenario.gait,
                                   false, scenario.world.step_s, scenario.duration_s},
                                  &timer);
  int counted = 0, in_stance = 0;
  for (Tick tick = 0; tick < kWarmUp + kCounted; ++tick) {
    const SensorFrame frame = sensors.Read(world.truth(), tick);
    const std::int64_t before = CountAllocations();
    const ControlTick& control = controller.Update(frame);
    const std::int64_t taken = CountAllocations() - before;
    if (tick >= kWarmUp && !control.mpc.ran) {
      ASSERT_EQ(taken, 0) << "at tick " << tick;
      ++counted;
      in_stance += control.feet[0].planned_contact ? 1 : 0;
    }
    world.Apply(control.command);
    world.Step(tick);
  }
  EXPECT_GT(counted, kCounted / 2);
  EXPECT_GT(in_stance, 100);
  EXPECT_GT(counted - in_stance, 100) << "stance and flight";
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
}  // namespace sidestep
