// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/mjcf_schema.h"

#include <gtest/gtest.h>

namespace sidestep::importer {
namespace {

TEST(MjcfSchema, KnowsWhatThisMujocoKnows) {
  const MjcfSchema schema;
  EXPECT_TRUE(schema.HasAttribute("body", "joint", "armature"));
  EXPECT_TRUE(schema.HasAttribute("body", "joint", "user")) << "the last of several lines";
  EXPECT_TRUE(schema.HasAttribute("default", "position", "kp"));
  EXPECT_TRUE(schema.HasAttribute("body", "body", "childclass"));
  EXPECT_TRUE(schema.HasAttribute("mujoco", "compiler", "autolimits"));
  EXPECT_TRUE(schema.HasAttribute("body", "inertial", "mass"));
  EXPECT_TRUE(schema.HasAttribute("default", "default", "class"));
}

TEST(MjcfSchema, KnowsNothingElse) {
  const MjcfSchema schema;
  EXPECT_FALSE(schema.HasAttribute("body", "joint", "kp"));
  EXPECT_FALSE(schema.HasAttribute("body", "joint", "(*)"));
  EXPECT_FALSE(schema.HasAttribute("body", "jont", "name"));
  EXPECT_FALSE(schema.HasAttribute("body", "motor", "joint"));
}

}  // namespace
}  // namespace sidestep::importer
