// SPDX-License-Identifier: BSD-3-Clause
// A copy of the sensors reads on as its original would, whenever it is made.
#include <gtest/gtest.h>

#include <vector>

#include "models/support/require.h"
#include "sim/sensors/sensor_suite.h"
#include "tests/support/all_numbers.h"

namespace sidestep::sensor_copy_test {
namespace {

constexpr int kNumFrames = 60;
constexpr int kStepsPerFrame = 3;

/// All errors but the touch's: 25 normal numbers a frame. They come in pairs, so that after every
/// other frame the distribution holds a spare one.
SensorSetup BadSetup(std::uint64_t seed = 1) {
  SensorSetup setup;
  setup.seed = seed;
  setup.has_touch = {true};
  setup.permitted = {true, true, true};
  SensorParams& errors = setup.errors;
  errors.gyro_noise_radps = 0.01;
  errors.accelerometer_noise_mps2 = 0.2;
  errors.orientation_noise_rad = 0.002;
  errors.encoder_noise_rad = 0.001;
  errors.encoder_velocity_noise_radps = 0.05;
  errors.force_noise_N = 0.7;
  errors.torque_noise_Nm = 0.04;
  errors.delay_s = 0.004;
  errors.wrench_delay_s = 0.003;
  errors.dropout = 0.3;
  errors.encoder_bias_rad = 0.01;
  return setup;
}

/// Of step `step`: two joints, a foot, two force/torque sensors, all in motion.
WorldTruth TruthAt(int step) {
  WorldTruth truth;
  truth.p_WB = {0.01 * step, 2.0, 3.0};
  truth.joint_position = Eigen::Vector2d(0.5 + 0.02 * step, -0.5);
  truth.joint_velocity = Eigen::Vector2d(1.5, -2.5);
  truth.feet.resize(1);
  truth.feet[0].touch_N = 12.0 + step;
  truth.force_torque = {{{1.0 + step, 2.0, 3.0}, {0.1, 0.2, 0.3}},
                        {{-1.0, -2.0, 30.0 - step}, {-0.1, -0.2, -0.3}}};
  truth.pushes = {{{0.0, 1.0 * step, 0.0}, {1.1, 2.0, 3.7}}};
  return truth;
}

/// Step `step` of a run, and the frame at its end if there is one.
void Advance(int step, SensorSuite* sensors, std::vector<Numbers>* frames) {
  sensors->Accumulate(TruthAt(step));
  if ((step + 1) % kStepsPerFrame != 0) return;
  frames->push_back(AllNumbers(sensors->Read(TruthAt(step), step)));
}

std::vector<Numbers> FramesFrom(int first_step, SensorSuite sensors) {
  std::vector<Numbers> frames;
  for (int step = first_step; step < kNumFrames * kStepsPerFrame; ++step) {
    Advance(step, &sensors, &frames);
  }
  return frames;
}

/// Whether `tail` is how `frames` end, bit for bit.
bool IsEndOf(const std::vector<Numbers>& frames, const std::vector<Numbers>& tail) {
  const std::size_t start = frames.size() - tail.size();
  for (std::size_t i = 0; i < tail.size(); ++i) {
    if (!SameBits(frames[start + i], tail[i])) return false;
  }
  return true;
}

TEST(SensorCopyTest, ReadsOnAsItsOriginalFromEveryStep) {
  const std::vector<Numbers> expected = FramesFrom(0, SensorSuite(BadSetup()));
  ASSERT_EQ(expected.size(), static_cast<std::size_t>(kNumFrames));
  SensorSuite original(BadSetup());
  std::vector<Numbers> of_original;
  for (int step = 0; step < kNumFrames * kStepsPerFrame; ++step) {
    const SensorSuite copy = original;  // also between two steps of one frame's mean
    EXPECT_TRUE(IsEndOf(expected, FramesFrom(step, copy))) << step;
    Advance(step, &original, &of_original);
  }
  EXPECT_TRUE(IsEndOf(expected, of_original)) << "its copies' reading must not disturb it";
}

TEST(SensorCopyTest, AnotherSeedReadsSomethingElse) {
  EXPECT_FALSE(
      IsEndOf(FramesFrom(0, SensorSuite(BadSetup(1))), FramesFrom(0, SensorSuite(BadSetup(2)))));
}

TEST(SensorCopyTest, ASuiteNeedsARate) {
  SensorSetup setup;
  setup.rate_hz = 0.0;
  EXPECT_THROW(SensorSuite{setup}, ContractViolation);
}

}  // namespace
}  // namespace sidestep::sensor_copy_test
