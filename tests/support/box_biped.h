// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// box_biped: a small humanoid with servos. Each foot is three welded bodies, an ankle and two boxes
// with a force/torque sensor each, at sites turned every which way; the IMU is on the torso, and
// the arm ends in one more sensor. 22 kg; hips 0.05 + 0.2 + 0.2 m over the soles.

#include <cmath>
#include <string>

#include "models/robot_description/robot_description.h"
#include "sim/scenario/scenario.h"
#include "tests/support/temp_folder.h"

namespace sidestep {

namespace internal {

inline std::string BoxBipedLeg(const std::string& side, const std::string& y) {
  std::string leg = R"(
      <body name="@_hip" pos="0 YY 0">
        <joint name="@_hip_roll" axis="1 0 0" range="-0.5 0.5"/>
        <joint name="@_hip_pitch" axis="0 1 0" range="-1 1"/>
        <inertial pos="0 0 -0.1" mass="1.5" diaginertia="0.01 0.01 0.002"/>
        <body name="@_shank" pos="0 0 -0.2">
          <joint name="@_knee" axis="0 1 0" range="0 2"/>
          <inertial pos="0 0 -0.1" mass="1" diaginertia="0.006 0.006 0.001"/>
          <geom type="capsule" fromto="0 0 -0.05 0 0 -0.15" size="0.03" mass="0"/>
          <body name="@_ankle" pos="0 0 -0.2">
            <joint name="@_ankle_pitch" axis="0 1 0" range="-1 1"/>
            <joint name="@_ankle_roll" axis="1 0 0" range="-0.5 0.5"/>
            <inertial pos="0 0 -0.01" mass="0.5" diaginertia="0.001 0.001 0.001"/>
            <site name="@_sole" pos="0 0 -0.05"/>
            <body name="@_front" pos="0.05 0 -0.03">
              <geom type="box" size="0.05 0.03 0.02" mass="0.3"/>
              <site name="@_front_ft" pos="0.01 0.02 0.02" quat="0.8 0.36 -0.48 0"/>
            </body>
            <body name="@_rear" pos="-0.05 0 -0.03">
              <geom type="box" size="0.05 0.03 0.02" mass="0.2"/>
              <site name="@_rear_ft" pos="0 -0.01 0.02" quat="0 0.6 0 0.8"/>
            </body>
          </body>
        </body>
      </body>)";
  for (std::size_t at = leg.find('@'); at != std::string::npos; at = leg.find('@')) {
    leg.replace(at, 1, side);
  }
  return leg.replace(leg.find("YY"), 2, y);
}

inline std::string BoxBipedMjcf() {
  std::string xml = R"(<mujoco model="box_biped">
  <compiler angle="radian" autolimits="true"/>
  <default><joint type="hinge" armature="0.02" damping="0.1"/><motor ctrlrange="-60 60"/></default>
  <worldbody>
    <body name="pelvis" pos="0 0 0.5">
      <freejoint/>
      <inertial pos="0 0 0.02" mass="7" diaginertia="0.06 0.05 0.05"/>)" +
                    BoxBipedLeg("l", "0.07") + BoxBipedLeg("r", "-0.07") + R"(
      <body name="torso" pos="0.01 0 0.1">
        <joint name="waist" axis="0 0 1" range="-1 1"/>
        <inertial pos="0 0 0.1" mass="6" diaginertia="0.05 0.04 0.03"/>
        <geom type="sphere" size="0.08" pos="0 0 0.12" mass="0"/>
        <site name="imu" pos="0 0 0.15" quat="0.8 0 0.6 0"/>
        <body name="r_arm" pos="0 -0.15 0.2">
          <joint name="shoulder" axis="0 1 0" range="-2 2"/>
          <inertial pos="0 0 -0.1" mass="1.2" diaginertia="0.003 0.003 0.001"/>
          <body name="r_hand" pos="0 0 -0.2">
            <inertial pos="0 0 -0.05" mass="0.8" diaginertia="0.001 0.001 0.001"/>
            <site name="r_arm_ft" quat="0.6 0.8 0 0"/>
            <site name="r_palm" pos="0 0 -0.1"/>
          </body>
        </body>
      </body>
    </body>
  </worldbody>
  <actuator>)";
  for (const char* joint :
       {"shoulder", "waist", "l_hip_roll", "l_hip_pitch", "l_knee", "l_ankle_pitch", "l_ankle_roll",
        "r_hip_roll", "r_hip_pitch", "r_knee", "r_ankle_pitch", "r_ankle_roll"}) {
    xml += std::string("\n    <motor joint=\"") + joint + "\"/>";
  }
  xml += R"(
  </actuator>
  <sensor>
    <framequat name="imu_orientation" objtype="site" objname="imu"/>
    <gyro name="imu_gyro" site="imu"/>
    <accelerometer name="imu_accelerometer" site="imu"/>)";
  for (const std::string name :
       {"l_front_ft", "l_rear_ft", "r_front_ft", "r_rear_ft", "r_arm_ft"}) {
    xml += "\n    <force name=\"" + name + "_force\" site=\"" + name + "\"/>";
    xml += "\n    <torque name=\"" + name + "_torque\" site=\"" + name + "\"/>";
  }
  return xml + "\n  </sensor>\n</mujoco>\n";
}

}  // namespace internal

/// Mass of the two boxes of a foot together, below its sensors (kg).
inline constexpr double kBoxFootMass_kg = 0.5;

/// Describes the robot, its knees bent by 0.6 rad; its MJCF is written into `folder`.
inline RobotDescription BoxBiped(const TempFolder& folder) {
  RobotDescription robot;
  robot.name = "box_biped";
  robot.file = "box_biped/robot.yaml";
  robot.model = ReadMjcfModel(folder.Write("box_biped.xml", internal::BoxBipedMjcf()));
  robot.base = "pelvis";
  robot.imu = "imu";
  robot.base_height_m = 0.05 + 0.4 * std::cos(0.3);
  robot.com_height_m = 0.47;
  robot.force_torque = {"r_arm_ft", "l_front_ft", "l_rear_ft", "r_front_ft", "r_rear_ft"};
  robot.arm_force_torque = {"r_arm_ft"};
  Eigen::Matrix3Xd corners_m(3, 4);
  corners_m << 0.1, 0.1, -0.1, -0.1, 0.03, -0.03, 0.03, -0.03, 0, 0, 0, 0;
  robot.feet = {{"left", "l_sole", {"l_front_ft", "l_rear_ft"}, corners_m, 0.0},
                {"right", "r_sole", {"r_front_ft", "r_rear_ft"}, corners_m, 0.0}};
  for (const char* joint :
       {"shoulder", "waist", "l_hip_roll", "l_hip_pitch", "l_knee", "l_ankle_pitch", "l_ankle_roll",
        "r_hip_roll", "r_hip_pitch", "r_knee", "r_ankle_pitch", "r_ankle_roll"}) {
    robot.joints.push_back({joint, 400.0, 8.0, 10.0, 1.0});
  }
  for (const std::string side : {"l", "r"}) {
    robot.home[side + "_hip_pitch"] = -0.3;
    robot.home[side + "_knee"] = 0.6;
    robot.home[side + "_ankle_pitch"] = -0.3;
  }
  return robot;
}

/// A scenario with that robot and nothing else.
inline Scenario BoxBipedScenario(const TempFolder& folder) {
  Scenario scenario;
  scenario.name = "box_biped";
  scenario.robot_name = "box_biped";
  scenario.duration_s = 1.0;
  scenario.robot = BoxBiped(folder);
  scenario.gait.resize(1);
  return scenario;
}

}  // namespace sidestep
