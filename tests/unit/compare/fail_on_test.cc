// SPDX-License-Identifier: BSD-3-Clause
#include "sim/compare/fail_on.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "models/support/config_error.h"

namespace sidestep {
namespace {

bool Holds(const std::string& text, double first, double second) {
  return Fails(ParseFailOn(text), first, second);
}

TEST(FailOnTest, AValueAChangeAndAShare) {
  EXPECT_TRUE(Holds("m>0.2", 9.0, 0.3));
  EXPECT_FALSE(Holds("m>0.2", 0.0, 0.2)) << "the bound itself is fine";
  EXPECT_TRUE(Holds("m>+0.1", 1.0, 1.2));
  EXPECT_FALSE(Holds("m>+0.1", 1.0, 1.05));
  EXPECT_TRUE(Holds("m>+10%", 2.0, 2.3));
  EXPECT_FALSE(Holds("m>+10%", 2.0, 2.1));
  EXPECT_TRUE(Holds("m<-10%", 2.0, 1.7));
  EXPECT_TRUE(Holds("m<-10%", -2.0, -2.3)) << "a share is of A's size";
  EXPECT_TRUE(Holds("recovered<1", 1.0, 0.0));
}

TEST(FailOnTest, WhatIsNoNumberAnyMoreFails) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(Holds("m>+10%", 1.0, kNan));
  EXPECT_FALSE(Holds("m>+10%", kNan, kNan));
  EXPECT_TRUE(Holds("m>+10%", kNan, 1.0));
  EXPECT_FALSE(Holds("m>2", kNan, 1.0));
  EXPECT_FALSE(Holds("m>+1", kInfinity, kInfinity));
}

TEST(FailOnTest, OneLineTellsWhatItMustRead) {
  for (const char* text : {"", "m", ">1", "m>", "m>x", "m>10%", "m>+1e999", "m>+1 %"}) {
    EXPECT_THROW(ParseFailOn(text), ConfigError) << text;
  }
}

}  // namespace
}  // namespace sidestep
