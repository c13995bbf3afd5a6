// SPDX-License-Identifier: BSD-3-Clause
#include "models/mjcf/mjcf_message.h"

#include <gtest/gtest.h>

namespace sidestep {
namespace {

TEST(MjcfMessage, TakesThePlaceOutOfEveryKindOfComplaint) {
  const MjcfMessage compiler = ReadMjcfMessage("Error: bad\nObject name = a, line = 3, column = 7");
  EXPECT_EQ(compiler.what, "Error: bad; Object name = a");
  EXPECT_EQ(compiler.line, 3);
  EXPECT_EQ(compiler.column, 7);
  const MjcfMessage schema = ReadMjcfMessage("Schema violation: x\nline 12, column 4");
  EXPECT_EQ(schema.line, 12);
  EXPECT_EQ(schema.column, 4);
  EXPECT_EQ(ReadMjcfMessage("XML parse error Line number=5").line, 5);
}

TEST(MjcfMessage, UnknownPlacesAreZero) {
  const MjcfMessage message = ReadMjcfMessage("Error: no mass\nid = 1, line = 0, column = -1");
  EXPECT_EQ(message.line, 0);
  EXPECT_EQ(message.column, 0);
  EXPECT_EQ(message.what, "Error: no mass; id = 1");
}

}  // namespace
}  // namespace sidestep
