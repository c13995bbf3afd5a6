// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/mjcf_motors.h"

#include "tests/unit/import/source_of.h"

namespace sidestep::importer {
namespace {

/// The hip's, with these actuators.
SourceJoint HipWith(const std::string& actuators) {
  const SourceRobot robot = SourceOfMjcf(SmallMjcf("", "<actuator>" + actuators + "</actuator>"));
  return robot.joints[static_cast<std::size_t>(JointCalled(robot, "hip"))];
}

TEST(MjcfMotors, LimitsComeThroughTheGear) {
  EXPECT_EQ(HipWith("<motor joint=\"hip\" gear=\"-50\" ctrlrange=\"-2 2\"/>").effort_Nm, 100.0);
  EXPECT_EQ(HipWith("<motor joint=\"hip\" gear=\"50\" ctrlrange=\"-2 2\" forcerange=\"-1 1\"/>")
                .effort_Nm,
            50.0);
  EXPECT_EQ(HipWith("<motor joint=\"hip\" ctrlrange=\"-3 8\"/>").effort_Nm, 3.0);
  EXPECT_EQ(HipWith("<motor joint=\"hip\" ctrlrange=\"0 8\"/>").effort_Nm, 8.0);
  EXPECT_EQ(HipWith("<motor joint=\"hip\" ctrlrange=\"-1 1\"/>"
                    "<general joint=\"hip\" gainprm=\"6\" ctrlrange=\"-1 1\"/>")
                .effort_Nm,
            7.0)
      << "two of them pull together";
  EXPECT_EQ(HipWith("<motor joint=\"hip\"/>").effort_Nm, 0.0) << "nobody says";
  EXPECT_EQ(HipWith("").effort_Nm, 0.0);
}

TEST(MjcfMotors, AServoIsBoundByItsForceNotByItsReference) {
  const SourceJoint hip = HipWith(
      "<position joint=\"hip\" kp=\"100\" gear=\"2\" ctrlrange=\"-1 1\" forcerange=\"-30 "
      "30\"/>");
  EXPECT_EQ(hip.effort_Nm, 60.0);
  EXPECT_EQ(hip.servo_stiffness_Nm_per_rad, 400.0) << "through the gear there and back";
  EXPECT_EQ(hip.servo_damping_Nms_per_rad, 0.0);
}

TEST(MjcfMotors, DampingIsReadOfBothKindsOfServo) {
  EXPECT_EQ(HipWith("<position joint=\"hip\" kp=\"100\" kv=\"7\"/>").servo_damping_Nms_per_rad,
            7.0);
  const SourceJoint hip =
      HipWith("<general joint=\"hip\" gainprm=\"100\" biastype=\"affine\" biasprm=\"0 -100 -7\"/>");
  EXPECT_EQ(hip.servo_stiffness_Nm_per_rad, 100.0);
  EXPECT_EQ(hip.servo_damping_Nms_per_rad, 7.0);
}

TEST(MjcfMotors, ARatioOfDampingIsOfTheJointsInertia) {
  // The leg's inertia about the hip is 1 kg m^2: 2 * 0.7 * sqrt(100 * 1).
  const double damping = 14.0;
  EXPECT_NEAR(
      HipWith("<position joint=\"hip\" kp=\"100\" dampratio=\"0.7\"/>").servo_damping_Nms_per_rad,
      damping, 1e-9);
  EXPECT_NEAR(HipWith("<position joint=\"hip\" kp=\"25\" gear=\"-2\" dampratio=\"0.7\"/>")
                  .servo_damping_Nms_per_rad,
              damping, 1e-9)
      << "through the gear";
  EXPECT_NEAR(HipWith("<general joint=\"hip\" gainprm=\"100\" biastype=\"affine\" "
                      "biasprm=\"0 -100 0.7\"/>")
                  .servo_damping_Nms_per_rad,
              damping, 1e-9)
      << "today's MuJoCo writes a ratio so";
}

TEST(MjcfMotors, AnElementsDampingReplacesItsClasss) {
  const auto damping = [](const std::string& of_class, const std::string& own) {
    return SourceOfMjcf(
               SmallMjcf("",
                         "<actuator><position joint=\"hip\" kp=\"100\" " + own + "/></actuator>",
                         "<default><position " + of_class + "/></default>"))
        .joints[0]
        .servo_damping_Nms_per_rad;
  };
  EXPECT_NEAR(damping("dampratio=\"1\"", ""), 20.0, 1e-9);
  EXPECT_NEAR(damping("kv=\"3\"", "dampratio=\"1\""), 20.0, 1e-9);
  EXPECT_EQ(damping("dampratio=\"1\"", "kv=\"3\""), 3.0);
  EXPECT_EQ(damping("dampratio=\"1\"", "dampratio=\"0\""), 0.0);
}

TEST(MjcfMotors, ABiasThatIsNoServosIsNone) {
  const SourceJoint hip =
      HipWith("<general joint=\"hip\" gainprm=\"100\" biastype=\"affine\" biasprm=\"0 -50 -7\"/>");
  EXPECT_EQ(hip.servo_stiffness_Nm_per_rad, 0.0);
}

TEST(MjcfMotors, JointsWithoutAMotorAreTold) {
  Notes notes;
  SourceOfMjcf(SmallMjcf(""), &notes);
  EXPECT_TRUE(HasNote(notes, "the MJCF has no motor for joints 'hip'"));
}

}  // namespace
}  // namespace sidestep::importer
