// SPDX-License-Identifier: BSD-3-Clause
#include "sim/record/column_digits.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>

#include "models/support/parse_number.h"
#include "models/support/require.h"

namespace sidestep::column_digits_test {
namespace {

std::string Rounded(double value, int decimals) {
  std::string text;
  AppendRounded(text, value, decimals);
  return text;
}

TEST(ColumnDigitsTest, EveryUnitHasItsResolution) {
  EXPECT_EQ(DecimalsOf("truth_p_WC_x_m"), 7);
  EXPECT_EQ(DecimalsOf("truth_tilt_rad"), 7);
  EXPECT_EQ(DecimalsOf("truth_q_WB_w"), 7);
  EXPECT_EQ(DecimalsOf("truth_v_WC_x_mps"), 6);
  EXPECT_EQ(DecimalsOf("command_knee_radps"), 5);
  EXPECT_EQ(DecimalsOf("truth_f_F_W_left_z_N"), 3);
  EXPECT_EQ(DecimalsOf("joint_knee_Nm"), 4);
  EXPECT_EQ(DecimalsOf("truth_h_C_W_x_kgm2ps"), 6);
  EXPECT_EQ(DecimalsOf("wall_mpc_ms"), 3);
  EXPECT_EQ(DecimalsOf("mpc_age_s"), 6);
  EXPECT_EQ(DecimalsOf("wbc_status"), 7);
}

TEST(ColumnDigitsTest, TheUnitIsWhatStandsAfterTheLastUnderscore) {
  EXPECT_EQ(ColumnUnit("truth_v_WC_x_mps"), "mps");
  EXPECT_EQ(ColumnUnit("time_s"), "s");
  EXPECT_EQ(ColumnUnit("truth_q_WB_w"), "");
  EXPECT_EQ(ColumnUnit("m"), "");
  EXPECT_EQ(ColumnUnit("arm"), "");
  EXPECT_EQ(ColumnUnit(""), "");
}

TEST(ColumnDigitsTest, TrailingZerosAndTheSignOfZeroAreDropped) {
  EXPECT_EQ(Rounded(1.0, 7), "1");
  EXPECT_EQ(Rounded(0.5, 3), "0.5");
  EXPECT_EQ(Rounded(1200.0, 3), "1200");
  EXPECT_EQ(Rounded(1200.0, 0), "1200");
  EXPECT_EQ(Rounded(0.0, 7), "0");
  EXPECT_EQ(Rounded(-0.0, 7), "0");
  EXPECT_EQ(Rounded(-4e-8, 7), "0");
  EXPECT_EQ(Rounded(-0.4, 0), "0");
  EXPECT_EQ(Rounded(-6e-8, 7), "-0.0000001");
}

TEST(ColumnDigitsTest, WhatIsWrittenIsWithinHalfAResolution) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> exponent(-12.0, 6.0), sign(-1.0, 1.0);
  for (int i = 0; i < 20000; ++i) {
    const double value = std::copysign(std::pow(10.0, exponent(random)), sign(random));
    const int decimals = i % 10;
    const double back = ParseAs<double>(Rounded(value, decimals)).value();
    // Reading back rounds once more, to a double.
    const double slack = 1e-15 * std::abs(value);
    EXPECT_LE(std::abs(back - value), 0.5 * std::pow(10.0, -decimals) + slack) << value;
  }
}

TEST(ColumnDigitsTest, WhatIsTooLargeForItKeepsAllItsDigits) {
  for (const double value : {1e15, -123456789012345678.0, 1e300, -1.7e308}) {
    EXPECT_EQ(ParseAs<double>(Rounded(value, 7)), value);
  }
  EXPECT_EQ(Rounded(999999999999999.0, 9), "999999999999999");
  EXPECT_EQ(Rounded(std::numeric_limits<double>::infinity(), 3), "inf");
  EXPECT_EQ(Rounded(std::nan(""), 3), "nan");
}

TEST(ColumnDigitsTest, MorePlacesThanItsBufferHoldsBreakTheContract) {
  EXPECT_THROW(Rounded(1.0, 10), ContractViolation);
  EXPECT_THROW(Rounded(1.0, -1), ContractViolation);
}

}  // namespace
}  // namespace sidestep::column_digits_test
