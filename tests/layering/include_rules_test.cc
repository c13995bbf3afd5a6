// SPDX-License-Identifier: BSD-3-Clause
// The rule engine on made-up sources: it must be able to fail.

#include "tests/layering/include_rules.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace sidestep::layering {
namespace {

const std::vector<Room> kRooms{{"models/support", {}},
                               {"controller/mpc", {"models/support"}},
                               {"controller/model", {"models/support"}, true},
                               {"sim/world", {"models/support", "controller/mpc"}, true}};

Source File(const std::string& path, std::vector<std::string> lines) {
  return {path, std::move(lines)};
}

// The violations of `lines` as a file of controller/mpc beside one header in each room.
std::vector<std::string> InMpc(const std::vector<std::string>& lines) {
  return IncludeViolations({File("models/support/a.h", {}), File("controller/model/b.h", {}),
                            File("controller/mpc/own.h", {}), File("sim/world/c.h", {}),
                            File("controller/mpc/x.cc", lines)},
                           kRooms);
}

TEST(IncludeRulesTest, AllowedAndOwnAndStandardHeadersPass) {
  EXPECT_TRUE(InMpc({"#include <vector>", "#include \"models/support/a.h\"",
                     "#include \"controller/mpc/own.h\"", "#include <Eigen/Core>"})
                  .empty());
}

TEST(IncludeRulesTest, AnIncludeOfTheFloorAboveFailsWithItsPlace) {
  const auto violations = InMpc({"", "#include \"sim/world/c.h\""});
  ASSERT_EQ(violations.size(), 1U);
  EXPECT_EQ(violations[0], "controller/mpc/x.cc:2: controller/mpc may not include sim/world");
}

TEST(IncludeRulesTest, ASiblingThatTheTableDoesNotNameFails) {
  EXPECT_EQ(InMpc({"#include \"controller/model/b.h\""}).size(), 1U);
}

TEST(IncludeRulesTest, ASingleHeaderMayBeAllowedWithoutItsRoom) {
  const std::vector<Room> rooms{{"sim/a", {"sim/b/names.h"}}, {"sim/b", {}}};
  const std::vector<Source> sources{
      File("sim/b/names.h", {}), File("sim/b/rest.h", {}),
      File("sim/a/x.cc", {"#include \"sim/b/names.h\"", "#include \"sim/b/rest.h\""})};
  const auto violations = IncludeViolations(sources, rooms);
  ASSERT_EQ(violations.size(), 1U);
  EXPECT_EQ(violations[0], "sim/a/x.cc:2: sim/a may not include sim/b");
}

TEST(IncludeRulesTest, MujocoFailsOutsideTheRoomsThatMayUseIt) {
  EXPECT_EQ(InMpc({"#include <mujoco/mujoco.h>"}).size(), 1U);
  EXPECT_EQ(InMpc({"#include \"mujoco/mujoco.h\""}).size(), 1U);
  EXPECT_TRUE(
      IncludeViolations({File("controller/model/b.cc", {"#include <mujoco/mujoco.h>"})}, kRooms)
          .empty());
}

TEST(IncludeRulesTest, ClockConsoleThreadRandomnessAndFilesFailInControllerOnly) {
  for (const std::string header :
       {"chrono", "iostream", "thread", "random", "fstream", "mutex", "ctime"}) {
    const std::string line = "  #  include <" + header + ">  // why not";
    EXPECT_EQ(InMpc({line}).size(), 1U) << header;
    EXPECT_TRUE(IncludeViolations({File("sim/world/c.cc", {line})}, kRooms).empty()) << header;
  }
}

TEST(IncludeRulesTest, AFileThatNoRoomOwnsFails) {
  EXPECT_EQ(IncludeViolations({File("controller/mpc/deeper/x.cc", {})}, kRooms).size(), 1U);
  EXPECT_EQ(IncludeViolations({File("sim/x.cc", {})}, kRooms).size(), 1U);
}

TEST(IncludeRulesTest, SeeingNoFileFails) {
  EXPECT_EQ(IncludeViolations({}, kRooms).size(), 1U);
  EXPECT_EQ(FormViolations({}).size(), 1U);
}

TEST(IncludeRulesTest, AnIncludeThatIsNotAPathFromTheRootFails) {
  EXPECT_EQ(InMpc({"#include \"own.h\""}).size(), 1U);
  EXPECT_EQ(InMpc({"#include \"../support/a.h\""}).size(), 1U);
}

TEST(IncludeRulesTest, ACommentedOutIncludeDoesNotCount) {
  EXPECT_TRUE(InMpc({"// #include \"sim/world/c.h\""}).empty());
}

TEST(FormRulesTest, MissingLicenceMissingGuardAndLengthFailOneEach) {
  const std::string spdx = "// SPDX-License-Identifier: BSD-3-Clause";
  EXPECT_TRUE(FormViolations({File("a.h", {spdx, "#pragma once"})}).empty());
  EXPECT_TRUE(FormViolations({File("a.cc", {spdx})}).empty());
  EXPECT_EQ(FormViolations({File("a.h", {spdx})}).size(), 1U);
  EXPECT_EQ(FormViolations({File("a.cc", {"", spdx})}).size(), 1U);
  std::vector<std::string> lines(kMostLines - 1, "");
  lines[0] = spdx;
  EXPECT_TRUE(FormViolations({File("a.cc", lines)}).empty());
  lines.emplace_back();
  EXPECT_EQ(FormViolations({File("a.cc", lines)}).size(), 1U);
}

TEST(FormRulesTest, AFileOfManyLinesIsNotedButPasses) {
  std::vector<std::string> lines(kManyLines, "");
  lines[0] = "// SPDX-License-Identifier: BSD-3-Clause";
  EXPECT_EQ(LongFiles({File("a.cc", lines)}).size(), 1U);
  EXPECT_TRUE(FormViolations({File("a.cc", lines)}).empty());
}

}  // namespace
}  // namespace sidestep::layering
