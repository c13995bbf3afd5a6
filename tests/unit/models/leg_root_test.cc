// SPDX-License-Identifier: BSD-3-Clause
#include "models/mjcf/leg_root.h"

#include <gtest/gtest.h>

#include <array>

#include "models/mjcf/mjcf.h"

namespace sidestep::leg_root_test {
namespace {

/// A trunk on which a pelvis with two legs and an arm hang, and a mast on the left leg.
class LegRootTest : public testing::Test {
 protected:
  static std::string Body(const std::string& name, const std::string& inside) {
    return "<body name='" + name + "'><joint axis='0 1 0'/><geom size='0.1'/><site name='" + name +
           "'/>" + inside + "</body>";
  }
  int Id(const std::string& body) const { return RequireId(*model_, mjOBJ_BODY, body); }
  int Site(const std::string& body) const { return RequireId(*model_, mjOBJ_SITE, body); }

  const MjModelPtr model_{CompileMjcf(
      "<mujoco><worldbody><body name='trunk'><freejoint/><geom size='0.1'/><site name='trunk'/>" +
          Body("pelvis", Body("left", Body("left_foot", "") + Body("mast", "")) +
                             Body("right", Body("right_foot", ""))) +
          Body("arm", "") + "</body></worldbody></mujoco>",
      "", "test")};
};

TEST_F(LegRootTest, LegsBeginWhereTheyBranchOff) {
  const std::array feet{Site("left_foot"), Site("right_foot")};
  EXPECT_EQ(RootOfLegs(*model_, feet, Id("trunk")), Id("pelvis"));
  const std::array hands{Site("arm"), Site("right_foot")};
  EXPECT_EQ(RootOfLegs(*model_, hands, Id("trunk")), Id("trunk"));
  const std::array one_leg{Site("left_foot"), Site("mast")};
  EXPECT_EQ(RootOfLegs(*model_, one_leg, Id("trunk")), Id("left"));
}

TEST_F(LegRootTest, OneFootsLegBeginsAtTheBase) {
  const std::array foot{Site("left_foot")};
  EXPECT_EQ(RootOfLegs(*model_, foot, Id("trunk")), Id("trunk"));
}

TEST_F(LegRootTest, ABodyIsAtOrBelowItselfAndWhatCarriesIt) {
  EXPECT_TRUE(IsAtOrBelow(*model_, Id("left_foot"), Id("left_foot")));
  EXPECT_TRUE(IsAtOrBelow(*model_, Id("left_foot"), Id("pelvis")));
  EXPECT_FALSE(IsAtOrBelow(*model_, Id("pelvis"), Id("left_foot")));
  EXPECT_FALSE(IsAtOrBelow(*model_, Id("arm"), Id("pelvis")));
}

}  // namespace
}  // namespace sidestep::leg_root_test
