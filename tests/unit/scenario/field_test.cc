// SPDX-License-Identifier: BSD-3-Clause
#include "controller/types/field.h"

#include <gtest/gtest.h>

#include <string>

#include "sim/verdict/metrics.h"

namespace sidestep::field_test {
namespace {

TEST(UnitOfTest, ANameEndsInItsUnit) {
  EXPECT_EQ(UnitOf("duration_s"), "s");
  EXPECT_EQ(UnitOf("solve_time_ms"), "ms");
  EXPECT_EQ(UnitOf("rate_hz"), "Hz");
  EXPECT_EQ(UnitOf("compliance_radps_per_Nm"), "rad/s/(N m)");
  EXPECT_EQ(UnitOf("compliance_mps_per_N"), "m/s/N");
  EXPECT_EQ(UnitOf("step_length_m"), "m");
  EXPECT_EQ(UnitOf("landing_speed_mps"), "m/s");
  EXPECT_EQ(UnitOf("accelerometer_noise_mps2"), "m/s^2");
  EXPECT_EQ(UnitOf("max_tilt_rad"), "rad");
  EXPECT_EQ(UnitOf("gyro_bias_radps"), "rad/s");
  EXPECT_EQ(UnitOf("force_N"), "N");
  EXPECT_EQ(UnitOf("torque_noise_Nm"), "N m");
  EXPECT_EQ(UnitOf("impulse_Ns"), "N s");
  EXPECT_EQ(UnitOf("mass_kg"), "kg");
  EXPECT_EQ(UnitOf("com_damping_per_s"), "1/s");
  EXPECT_EQ(UnitOf("com_stiffness_per_s2"), "1/s^2");
  EXPECT_EQ(UnitOf("stiffness_N_per_m"), "N/m");
  EXPECT_EQ(UnitOf("servo_stiffness_Nm_per_rad"), "N m/rad");
  EXPECT_EQ(UnitOf("servo_damping_Nms_per_rad"), "N m s/rad");
  EXPECT_EQ(UnitOf("max_angular_momentum_kgm2ps"), "kg m^2/s");
}

TEST(UnitOfTest, ANameWithoutAnEndingHasNone) {
  for (const char* name : {"friction", "knots", "com_weight", "fps", "s", "m", "N", "_", "", "sums",
                           "steps", "mass_scale", "min_base_height_ratio"}) {
    EXPECT_EQ(UnitOf(name), "") << name;
  }
}

// Two writers of one fact: the metrics' table says its units itself.
TEST(UnitOfTest, AgreesWithEveryMetric) {
  for (const MetricInfo& metric : KnownMetrics()) EXPECT_EQ(UnitOf(metric.name), metric.unit);
}

}  // namespace
}  // namespace sidestep::field_test
