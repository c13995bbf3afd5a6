// SPDX-License-Identifier: BSD-3-Clause
#include "models/robot_description/robot_figures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "models/support/config_text.h"
#include "tests/support/temp_folder.h"

namespace sidestep::robot_figures_test {
namespace {

const std::filesystem::path kHumanoid =
    std::filesystem::path(SIDESTEP_SOURCE_DIR) / "models/generic_humanoid";

const ServoFigures& Servo(const RobotFigures& figures, const std::string& joint) {
  return *std::find_if(figures.servos.begin(), figures.servos.end(),
                       [&](const ServoFigures& servo) { return servo.joint == joint; });
}

TEST(RobotFiguresTest, OfTheHumanoid) {
  const RobotFigures figures = FiguresOf(ReadRobotDescription(kHumanoid / "robot.yaml"));
  EXPECT_NEAR(figures.mass_kg, 60.0, 1e-3);
  EXPECT_NEAR(figures.com_height_m, 0.8149, 1e-4);
  EXPECT_NEAR(figures.omega_per_s, std::sqrt(9.81 / 0.8149), 1e-9);
  ASSERT_EQ(figures.soles.size(), 2U);
  EXPECT_NEAR(figures.soles[0].length_m, 0.2, 1e-12);
  EXPECT_NEAR(figures.soles[0].width_m, 0.09, 1e-12);
  EXPECT_NEAR(figures.soles[0].p_WF.z(), 0.0, 1e-9);
  EXPECT_NEAR(figures.soles[0].leg_length_m, 0.74, 1e-3);  // 0.06 m of hip, two links of 0.34
  EXPECT_EQ(figures.servos.size(), 21U);
}

TEST(RobotFiguresTest, JointsThatKeepTheLegsUprightCarryMGH) {
  const RobotFigures figures = FiguresOf(ReadRobotDescription(kHumanoid / "robot.yaml"));
  const double mgh = figures.mass_kg * 9.81 * 0.8149;
  EXPECT_NEAR(Servo(figures, "left_ankle_pitch").carries_Nm_per_rad, mgh, 1e-6);
  EXPECT_NEAR(Servo(figures, "right_ankle_roll").carries_Nm_per_rad, mgh, 1e-6);
  EXPECT_EQ(Servo(figures, "left_hip_yaw").carries_Nm_per_rad, 0.0) << "upright axis";
  EXPECT_EQ(Servo(figures, "left_elbow").carries_Nm_per_rad, 0.0) << "no leg";
}

TEST(RobotFiguresTest, AJointMovesItsArmatureAndLinks) {
  const RobotFigures figures = FiguresOf(ReadRobotDescription(kHumanoid / "robot.yaml"));
  for (const ServoFigures& servo : figures.servos) {
    EXPECT_GT(servo.inertia_kgm2, servo.armature_kgm2) << servo.joint;
  }
  // By hand: the bracket and the foot about the roll axis, 0.055 m above the foot's origin, little
  // beside 0.06 of armature.
  EXPECT_NEAR(Servo(figures, "left_ankle_roll").inertia_kgm2, 0.065, 0.004);
}

// Two poles inside the unit circle, found by iterating the map itself.
bool Settles(double damping_share, double stiffness_share) {
  double q = 1.0, v_dt = 0.0;
  for (int step = 0; step < 20000; ++step) {
    v_dt -= stiffness_share * q + damping_share * v_dt;
    q += v_dt;
  }
  return std::abs(q) < 1e-3;
}

TEST(RobotFiguresTest, AServoIsCalledStableOnlyWhereItsMapSettles) {
  for (const double a : {0.05, 0.5, 0.95, 1.5, 2.1}) {
    for (const double b : {0.01, 0.5, 1.5, 2.0, 3.0, 3.8, 4.5}) {
      const ServoFigures servo{"", b, a, 0.0, 1.0};  // a step of 1 s and an inertia of 1
      EXPECT_EQ(Settles(a, b), 2.0 * a + b < 4.0) << a << " " << b;
      EXPECT_TRUE(!servo.is_stable(1.0) || Settles(a, b)) << a << " " << b;
    }
  }
  EXPECT_FALSE((ServoFigures{"", 0.1, 1.1, 0.0, 1.0}.is_stable(1.0))) << "turns round in a step";
}

TEST(RobotFiguresTest, TooWeakServosAndMissingArmaturesAreWarnedOf) {
  EXPECT_TRUE(ServoWarnings(ReadRobotDescription(kHumanoid / "robot.yaml")).empty());
  const TempFolder folder;
  folder.Write("generic_humanoid.urdf", ReadConfigText(kHumanoid / "generic_humanoid.urdf"));
  std::string yaml = ReadConfigText(kHumanoid / "robot.yaml");
  yaml = Edit(yaml, "servo_stiffness_Nm_per_rad: 12000", "servo_stiffness_Nm_per_rad: 300");
  yaml = Edit(yaml, "    armature_kgm2: 0.05\n", "");
  const std::vector<std::string> warnings =
      ServoWarnings(ReadRobotDescription(folder.Write("robot.yaml", yaml)));
  ASSERT_EQ(warnings.size(), 2U);
  EXPECT_EQ(warnings[0].find("servo_stiffness_Nm_per_rad of 'left_"), 0U) << warnings[0];
  EXPECT_NE(warnings[0].find(" = 300 can't carry 60 kg at 0.8149 m: m g h = 479.7 Nm/rad"),
            std::string::npos)
      << warnings[0];
  EXPECT_EQ(warnings[1].find("1 of 21 joints have no armature_kgm2"), 0U) << warnings[1];
}

}  // namespace
}  // namespace sidestep::robot_figures_test
