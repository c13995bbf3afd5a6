// SPDX-License-Identifier: BSD-3-Clause
// When a frame was measured: delays, and frames that are lost.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/unit/sensors/sensors_test_support.h"

namespace sidestep::sensor_delay_test {
namespace {

TEST(SensorDelayTest, FramesAreAsOldAsTheDelay) {
  Scenario scenario = Quiet();
  scenario.sensors.delay_s = 0.003;
  SensorSuite sensors = MakeSensorSuite(scenario, 1.0);
  for (Tick tick = 0; tick < 20; ++tick) {
    const SensorFrame frame = sensors.Read(Truth(static_cast<double>(tick)), tick);
    const Tick measured = std::max<Tick>(0, tick - 3);
    EXPECT_EQ(frame.joint_position[0], 0.5 + static_cast<double>(measured)) << tick;
    EXPECT_EQ(frame.tick, tick) << "a frame is stamped when it arrives";
  }
}

TEST(SensorDelayTest, WrenchesAreOlderThanTheRestByTheirOwnDelay) {
  Scenario scenario = Quiet();
  scenario.sensors.delay_s = 0.002;
  scenario.sensors.wrench_delay_s = 0.003;
  SensorSuite sensors = MakeSensorSuite(scenario, 1.0);
  for (Tick tick = 0; tick < 20; ++tick) {
    const SensorFrame frame = sensors.Read(Truth(static_cast<double>(tick)), tick);
    EXPECT_EQ(frame.joint_position[0], 0.5 + static_cast<double>(std::max<Tick>(0, tick - 2)));
    EXPECT_EQ(frame.force_torque[0].force_N.x(),
              1.0 + static_cast<double>(std::max<Tick>(0, tick - 5)));
    const Tick sampled = std::max<Tick>(0, tick - 2);  // there is nothing older at first
    EXPECT_EQ(frame.force_torque_age_s, static_cast<double>(std::min<Tick>(sampled, 3)) / 1000.0);
  }
}

TEST(SensorDelayTest, DropoutRepeatsTheLastFrameAsOftenAsItsProbability) {
  Scenario scenario = Quiet();
  scenario.sensors.dropout = 0.3;
  SensorSuite sensors = MakeSensorSuite(scenario, 1.0);
  int repeats = 0;
  double last = sensors.Read(Truth(0.0), 0).joint_position[0];
  EXPECT_EQ(last, 0.5) << "the first frame never drops";
  for (Tick tick = 1; tick <= kSamples; ++tick) {
    const SensorFrame frame = sensors.Read(Truth(static_cast<double>(tick)), tick);
    const double now = frame.joint_position[0];
    const bool repeated = now == last;
    EXPECT_TRUE(repeated || now == 0.5 + static_cast<double>(tick)) << "neither old nor new";
    EXPECT_EQ(frame.tick, tick);
    repeats += repeated ? 1 : 0;
    last = now;
  }
  // Four standard deviations of a binomial share.
  EXPECT_NEAR(static_cast<double>(repeats) / kSamples, 0.3, 4.0 * std::sqrt(0.3 * 0.7 / kSamples));
}

}  // namespace
}  // namespace sidestep::sensor_delay_test
