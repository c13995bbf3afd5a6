// SPDX-License-Identifier: BSD-3-Clause
#include "models/support/hash_text.h"

#include <gtest/gtest.h>

namespace sidestep {
namespace {

TEST(HashTextTest, IsFnv1aOf64Bits) {
  // Test vectors of the algorithm's authors.
  EXPECT_EQ(HashText(""), "cbf29ce484222325");
  EXPECT_EQ(HashText("a"), "af63dc4c8601ec8c");
  EXPECT_EQ(HashText("foobar"), "85944171f73967e8");
}

}  // namespace
}  // namespace sidestep
