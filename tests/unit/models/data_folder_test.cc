// SPDX-License-Identifier: BSD-3-Clause
#include "models/support/data_folder.h"

#include <gtest/gtest.h>
#include <stdlib.h>

namespace sidestep {
namespace {

class DataFolderTest : public testing::Test {
 protected:
  ~DataFolderTest() override { unsetenv("SIDESTEP_DATA_DIR"); }
};

TEST_F(DataFolderTest, AProgramThatIsNotInstalledHasItsSourceTree) {
  unsetenv("SIDESTEP_DATA_DIR");
  EXPECT_EQ(DataFolder(), SIDESTEP_SOURCE_DIR);
}

TEST_F(DataFolderTest, TheEnvironmentGoesFirstEvenWhereNothingIs) {
  setenv("SIDESTEP_DATA_DIR", "/nowhere/at/all", 1);
  EXPECT_EQ(DataFolder(), "/nowhere/at/all");
}

TEST_F(DataFolderTest, AnEmptyVariableIsNone) {
  setenv("SIDESTEP_DATA_DIR", "", 1);
  EXPECT_EQ(DataFolder(), SIDESTEP_SOURCE_DIR);
}

}  // namespace
}  // namespace sidestep
