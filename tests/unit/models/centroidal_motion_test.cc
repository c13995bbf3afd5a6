// SPDX-License-Identifier: BSD-3-Clause
// Against MuJoCo's own sum over subtrees.
#include "models/mjcf/centroidal_motion.h"

#include <gtest/gtest.h>

#include "models/mjcf/mjcf.h"
#include "models/robot_description/robot_description.h"

namespace sidestep::centroidal_motion_test {
namespace {

/// A robot that ships, thrown: every coordinate and velocity at a different value.
class CentroidalMotionTest : public testing::TestWithParam<const char*> {
 protected:
  CentroidalMotionTest() {
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
  const MjModelPtr model_{CompileMjcf(robot_.model->drawn_mjcf, "", robot_.model->file)};
  const MjDataPtr data_{MakeData(*model_)};
};

INSTANTIATE_TEST_SUITE_P(Robots, CentroidalMotionTest, testing::Values("hopper", "icub3"),
                         [](const auto& test) { return std::string(test.param); });

TEST_P(CentroidalMotionTest, IsTheSumOverTheTree) {
  using ConstVector3Map = Eigen::Map<const Eigen::Vector3d>;
  const int root = RequireId(*model_, mjOBJ_BODY, robot_.base);
  const ConstVector3Map v_WC(data_->subtree_linvel + 3 * root);
  const ConstVector3Map angular_momentum(data_->subtree_angmom + 3 * root);
  const CentroidalMotion motion = CentroidalMotionOf(*model_, *data_, root);
  EXPECT_EQ(motion.p_WC, ConstVector3Map(data_->subtree_com + 3 * root));
  EXPECT_LT((motion.v_WC - v_WC).norm(), 1e-12 * v_WC.norm());
  EXPECT_LT((motion.angular_momentum - angular_momentum).norm(), 1e-12 * angular_momentum.norm());
  EXPECT_GT(v_WC.norm(), 0.5) << "no motion proves nothing";
  EXPECT_GT(angular_momentum.norm(), 0.01);
}

TEST(CentroidalMotionOfTwoTreesTest, EachTreeMovesOnItsOwn) {
  const MjModelPtr model = CompileMjcf(
      "<mujoco><worldbody>"
      "<body name='light'><freejoint/><geom type='sphere' size='0.1' mass='1'/></body>"
      "<body name='heavy' pos='1 0 0'><freejoint/><geom type='sphere' size='0.1' mass='9'/></body>"
      "</worldbody></mujoco>",
      "", "two_trees.xml");
  const MjDataPtr data = MakeData(*model);
  data->qvel[0] = 2.0;
  data->qvel[7] = 3.0;
  mj_fwdPosition(model.get(), data.get());
  mj_fwdVelocity(model.get(), data.get());
  const auto motion = [&](const char* body) {
    return CentroidalMotionOf(*model, *data, RequireId(*model, mjOBJ_BODY, body));
  };
  EXPECT_LT((motion("light").v_WC - Eigen::Vector3d(2.0, 0.0, 0.0)).norm(), 1e-15);
  EXPECT_LT((motion("heavy").v_WC - Eigen::Vector3d(0.0, 3.0, 0.0)).norm(), 1e-15);
  EXPECT_EQ(motion("heavy").p_WC.x(), 1.0);
}

}  // namespace
}  // namespace sidestep::centroidal_motion_test
