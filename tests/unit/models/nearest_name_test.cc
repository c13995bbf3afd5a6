// SPDX-License-Identifier: BSD-3-Clause
#include "models/support/nearest_name.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace sidestep::nearest_name_test {
namespace {

const std::vector<std::string> kNames{"swing_s", "swing_height_m", "stance_s", "fps"};

TEST(NearestNameTest, FindsOneLetterTooMany) {
  EXPECT_EQ(NearestName("swingg_s", kNames), "swing_s");
}

TEST(NearestNameTest, FindsOneLetterTooFew) {
  EXPECT_EQ(NearestName("swng_height_m", kNames), "swing_height_m");
}

TEST(NearestNameTest, CountsSwappedNeighboursOnce) {
  // Two substitutions would be too far from a name of three letters; one swap is not.
  EXPECT_EQ(NearestName("fsp", kNames), "fps");
}

TEST(NearestNameTest, PrefersTheNearer) { EXPECT_EQ(NearestName("stanc_s", kNames), "stance_s"); }

TEST(NearestNameTest, SaysNothingAboutADifferentWord) {
  EXPECT_EQ(NearestName("friction", kNames), "");
  EXPECT_EQ(NearestName("", kNames), "");
  EXPECT_EQ(NearestName("abc", kNames), "");
}

TEST(NearestNameTest, SaysNothingAboutAnAbsurdlyLongWord) {
  EXPECT_EQ(NearestName(std::string(100000, 's'), kNames), "");
}

TEST(NearestNameTest, SuggestsOrListsTheKnownOnes) {
  EXPECT_EQ(DidYouMean("stanse_s", kNames, "known keys"), "did you mean 'stance_s'?");
  EXPECT_EQ(DidYouMean("friction", kNames, "known keys"),
            "known keys: swing_s, swing_height_m, stance_s, fps");
  EXPECT_EQ(DidYouMean("a", {}, "known keys"), "known keys: none");
}

}  // namespace
}  // namespace sidestep::nearest_name_test
