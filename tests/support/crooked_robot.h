// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// crooked_robot: two unlike legs under a base, with nothing aligned: a zero or a symmetry can't
// hide a wrong sign, frame or order. Total mass 3 kg. Actuators are not in the order of the joints.

#include "models/robot_description/robot_description.h"
#include "tests/support/temp_folder.h"

namespace sidestep {

inline constexpr char kCrookedMjcf[] = R"(<mujoco model="crooked">
  <compiler angle="radian" autolimits="true" inertiafromgeom="false"/>
  <default><geom contype="0" conaffinity="0"/></default>
  <worldbody>
    <body name="base" pos="0 0 1">
      <freejoint/>
      <inertial pos="0.03 -0.02 0.05" mass="2.0" fullinertia="0.02 0.03 0.04 0.002 -0.003 0.001"/>
      <site name="imu" pos="0.05 0.02 -0.04" quat="0.8 0.36 -0.48 0"/>
      <body name="thigh_l" pos="0.02 0.1 -0.05">
        <joint name="hip_l" type="hinge" axis="1 0.2 0" armature="0.01" damping="0.3"/>
        <inertial pos="0.01 0 -0.1" mass="0.4" diaginertia="0.004 0.003 0.001"/>
        <body name="shank_l" pos="0 0.01 -0.25">
          <joint name="knee_l" type="hinge" axis="0 1 0.1" damping="0.1"/>
          <inertial pos="0 0.01 -0.1" mass="0.2" diaginertia="0.002 0.0018 0.0004"/>
          <site name="left_sole" pos="0.01 0.02 -0.2" euler="0.1 0.2 0.3"/>
        </body>
      </body>
      <body name="leg_r" pos="-0.03 -0.12 -0.05">
        <joint name="hip_r" type="hinge" axis="0.3 1 0"/>
        <joint name="slide_r" type="slide" axis="0.1 0 -1" armature="0.02" damping="0.4"/>
        <inertial pos="0 0.02 -0.15" mass="0.4" diaginertia="0.005 0.004 0.001"/>
        <site name="right_sole" pos="0 -0.01 -0.4"/>
      </body>
    </body>
  </worldbody>
  <actuator>
    <motor name="slide_r" joint="slide_r" ctrlrange="-80 80"/>
    <motor name="hip_l" joint="hip_l" ctrlrange="-20 20"/>
    <motor name="knee_l" joint="knee_l" ctrlrange="-30 30"/>
    <motor name="hip_r" joint="hip_r" ctrlrange="-25 25"/>
  </actuator>
</mujoco>)";

/// Describes the robot; its MJCF is written into `folder`.
inline RobotDescription CrookedRobot(const TempFolder& folder) {
  RobotDescription robot;
  robot.name = "crooked";
  robot.model = ReadMjcfModel(folder.Write("crooked.xml", kCrookedMjcf));
  robot.base = "base";
  robot.imu = "imu";
  robot.com_height_m = 0.9;
  robot.base_height_m = 1.0;
  const Eigen::Matrix3Xd point = Eigen::Vector3d::Zero();
  robot.feet = {{"left", "left_sole", {}, point, 0.0}, {"right", "right_sole", {}, point, 0.0}};
  return robot;
}

}  // namespace sidestep
