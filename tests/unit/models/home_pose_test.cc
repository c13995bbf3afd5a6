// SPDX-License-Identifier: BSD-3-Clause
// Where a run begins, on a robot whose feet are not under its base.
#include "models/robot_description/home_pose.h"

#include <gtest/gtest.h>

#include "models/mjcf/mjcf.h"
#include "models/mjcf/quaternion.h"
#include "models/support/config_error.h"
#include "tests/support/crooked_robot.h"

namespace sidestep::home_pose_test {
namespace {

constexpr double kRounding = 1e-12;
constexpr double kQuarter = 0.5 * 3.14159265358979323846;

class HomePoseTest : public testing::Test {
 protected:
  void Place() { PlaceAtHome(*model_, robot_, data_.get()); }

  double Joint(const char* name) const {
    return data_->qpos[model_->jnt_qposadr[RequireId(*model_, mjOBJ_JOINT, name)]];
  }

  Eigen::Vector3d Base() const { return Eigen::Map<const Eigen::Vector3d>(data_->qpos); }

  Eigen::Vector3d Site(const char* name) const {
    return Eigen::Map<const Eigen::Vector3d>(data_->site_xpos +
                                             3 * RequireId(*model_, mjOBJ_SITE, name));
  }

  TempFolder folder_;
  RobotDescription robot_{CrookedRobot(folder_)};
  MjModelPtr model_{CompileMjcf("<mujoco><include file=\"robot.xml\"/></mujoco>",
                                robot_.model->drawn_mjcf, robot_.model->file)};
  MjDataPtr data_{MakeData(*model_)};
};

TEST_F(HomePoseTest, MidpointOfTheFeetIsOverTheOriginAndTheBaseAtItsHeight) {
  robot_.base_height_m = 0.73;
  Place();
  EXPECT_EQ(Base().z(), 0.73);
  const Eigen::Vector3d midpoint = 0.5 * (Site("left_sole") + Site("right_sole"));
  EXPECT_LT(midpoint.head<2>().norm(), kRounding);
  // By hand, with the joints at zero: the soles are at (0.03, 0.13, -0.5) and (-0.03, -0.13, -0.45)
  // from the base, hence it is over their midpoint.
  EXPECT_LT((Site("left_sole") - Eigen::Vector3d(0.03, 0.13, 0.23)).norm(), kRounding);
  EXPECT_LT((Base() - Eigen::Vector3d(0.0, 0.0, 0.73)).norm(), kRounding);
}

TEST_F(HomePoseTest, OneFootStandsOnTheOriginThoughTheBaseDoesNot) {
  robot_.feet.resize(1);
  Place();
  EXPECT_LT((Base() - Eigen::Vector3d(-0.03, -0.13, 1.0)).norm(), kRounding);
}

TEST_F(HomePoseTest, JointsAreAtHomeByName) {
  robot_.home = {{"knee_l", 0.4}, {"slide_r", -0.05}};
  Place();
  EXPECT_EQ(Joint("knee_l"), 0.4);
  EXPECT_EQ(Joint("slide_r"), -0.05);
  EXPECT_EQ(Joint("hip_l"), 0.0);
  EXPECT_EQ(Joint("hip_r"), 0.0);
}

TEST_F(HomePoseTest, JointsWithoutAHomeAreAtZeroWhereverTheyWere) {
  Eigen::Map<Eigen::VectorXd>(data_->qpos, model_->nq).setConstant(0.3);
  robot_.home = {{"knee_l", 0.4}};
  Place();
  EXPECT_EQ(Joint("knee_l"), 0.4);
  EXPECT_EQ(Joint("hip_l"), 0.0);
  EXPECT_EQ(Joint("slide_r"), 0.0);
}

TEST_F(HomePoseTest, AttitudeIsRollThenPitchThenYawAboutTheWorldsAxes) {
  robot_.base_rpy_rad = {kQuarter, 0.0, kQuarter};
  Place();
  const Eigen::Quaterniond q_WB = FromMuJoCo(data_->qpos + 3);
  // By hand: the roll takes y to z and z to -y; the yaw then x to y and y to -x.
  EXPECT_LT((q_WB * Eigen::Vector3d::UnitX() - Eigen::Vector3d::UnitY()).norm(), kRounding);
  EXPECT_LT((q_WB * Eigen::Vector3d::UnitY() - Eigen::Vector3d::UnitZ()).norm(), kRounding);
  EXPECT_LT((q_WB * Eigen::Vector3d::UnitZ() - Eigen::Vector3d::UnitX()).norm(), kRounding);
  robot_.base_rpy_rad = {0.0, kQuarter, 0.0};
  Place();
  EXPECT_LT(
      (FromMuJoCo(data_->qpos + 3) * Eigen::Vector3d::UnitX() + Eigen::Vector3d::UnitZ()).norm(),
      kRounding)
      << "a positive pitch looks down";
}

TEST_F(HomePoseTest, KinematicsAreThoseOfTheConfiguration) {
  robot_.home = {{"hip_l", 0.3}};
  Place();
  const Eigen::Vector3d left_sole = Site("left_sole");
  mj_kinematics(model_.get(), data_.get());
  EXPECT_EQ(left_sole, Site("left_sole"));
}

TEST_F(HomePoseTest, NamesThatTheModelLacksAreConfigErrors) {
  robot_.home = {{"elbow", 0.4}};
  EXPECT_EQ(folder_.ErrorOf([&] { Place(); }),
            "error: the robot's MJCF has no joint called 'elbow'");
  robot_.home.clear();
  robot_.feet[1].frame = "paw";
  EXPECT_EQ(folder_.ErrorOf([&] { Place(); }), "error: the robot's MJCF has no site called 'paw'");
  robot_.base = "trunk";
  EXPECT_EQ(folder_.ErrorOf([&] { Place(); }),
            "error: the robot's MJCF has no body called 'trunk'");
}

TEST_F(HomePoseTest, TellsWhereFramesAndBodiesAre) {
  Place();
  const HomePose home(robot_);
  EXPECT_LT((home.X_WO("left_sole").translation() - Site("left_sole")).norm(), kRounding);
  EXPECT_LT((home.X_WO(robot_.base).translation() - Base()).norm(), kRounding);
  EXPECT_LT((home.X_WO(robot_.base).linear().determinant() - 1.0), kRounding);
  EXPECT_THROW(home.X_WO("nowhere"), ConfigError);
}

}  // namespace
}  // namespace sidestep::home_pose_test
