// SPDX-License-Identifier: BSD-3-Clause
// Against MuJoCo's own sum over subtrees.
#include "models/mjcf/momentum.h"

#include <gtest/gtest.h>

#include "models/mjcf/mjcf.h"
#include "models/robot_description/robot_description.h"

namespace sidestep::momentum_test {
namespace {

/// A robot that ships, thrown: every coordinate and velocity at a different value.
class MomentumTest : public testing::TestWithParam<const char*> {
 protected:
  MomentumTest() {
    for (int i = 7; i < model_->nq; ++i) data_->qpos[i] += 0.3 * mju_sin(2.0 * i);
    data_->qpos[0] = 0.7;
    mju_axisAngle2Quat(data_->qpos + 3, kAxis, 0.9);
    for (int i = 0; i < model_->nv; ++i) data_->qvel[i] = mju_cos(3.0 * i);
    mj_fwdPosition(model_.get(), data_.get());
    mj_fwdVelocity(model_.get(), data_.get());
    mj_subtreeVel(model_.get(), data_.get());
  }

  static constexpr mjtNum kAxis[3] = {0.6, 0.0, 0.8};
  const RobotDescription robot_{
      ReadRobotDescription(FindRobot(GetParam(), std::filesystem::path(SIDESTEP_SOURCE_DIR)))};
  const MjModelPtr model_{CompileMjcf(MjcfOf(robot_), "", ModelFile(robot_))};
  const MjDataPtr data_{MakeData(*model_)};
};

INSTANTIATE_TEST_SUITE_P(Robots, MomentumTest, testing::Values("hopper", "icub3"),
                         [](const auto& test) { return std::string(test.param); });

TEST_P(MomentumTest, IsTheSumOverTheTree) {
  const int root = RequireId(*model_, mjOBJ_BODY, robot_.base);
  const Eigen::Vector3d linear =
      model_->body_subtreemass[root] *
      Eigen::Map<const Eigen::Vector3d>(data_->subtree_linvel + 3 * root);
  const Eigen::Map<const Eigen::Vector3d> angular(data_->subtree_angmom + 3 * root);
  const Momentum momentum = MomentumOf(*model_, *data_, root);
  EXPECT_LT((momentum.linear - linear).norm(), 1e-12 * linear.norm());
  EXPECT_LT((momentum.angular - angular).norm(), 1e-12 * angular.norm());
  EXPECT_GT(linear.norm(), 0.5) << "no motion proves nothing";
  EXPECT_GT(angular.norm(), 0.01);
}

}  // namespace
}  // namespace sidestep::momentum_test
