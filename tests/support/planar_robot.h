// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// planar_robot: two unlike legs under a base that moves in the plane y = 0 alone. In the plane
// nothing is aligned; across it feet and CoM are as such a robot must have them. Total mass 3 kg.

#include <string>

#include "models/robot_description/robot_description.h"
#include "models/robot_description/sagittal_plane.h"
#include "tests/support/temp_folder.h"

namespace sidestep {

// The base's CoM is where the unlike legs at y = +-0.07 leave the robot's at 0: by hand,
// 2 y + (0.6 - 0.4) 0.07 = 0. Its MJCF's reference is neither at the origin nor at home.
inline constexpr char kPlanarMjcf[] = R"(<mujoco model="planar">
  <compiler angle="radian" autolimits="true" inertiafromgeom="false"/>
  <default><geom contype="0" conaffinity="0"/></default>
  <worldbody>
    <body name="base" pos="0.3 0 0.9">
      <joint name="base_x" type="slide" axis="1 0 0"/>
      <joint name="base_z" type="slide" axis="0 0 1"/>
      <joint name="base_pitch" type="hinge" axis="0 1 0"/>
      <inertial pos="0.03 -0.007 0.05" mass="2.0" fullinertia="0.02 0.03 0.04 0.002 -0.003 0.001"/>
      <site name="imu" pos="0.05 0 -0.04" euler="0 0.3 0"/>
      <site name="trunk" pos="0 0 0.1"/>
      <body name="thigh_l" pos="0.02 0.07 -0.05">
        <joint name="hip_l" type="hinge" axis="0 1 0" range="-2 2" armature="0.01" damping="0.3"/>
        <inertial pos="0.01 0 -0.1" mass="0.4" diaginertia="0.004 0.003 0.001"/>
        <body name="shank_l" pos="0 0 -0.25">
          <joint name="knee_l" type="hinge" axis="0 1 0" range="-2 2" damping="0.1"/>
          <inertial pos="0.02 0 -0.1" mass="0.2" diaginertia="0.002 0.0018 0.0004"/>
          <site name="left_sole" pos="0.01 0 -0.2" euler="0 0.2 0"/>
        </body>
      </body>
      <body name="leg_r" pos="-0.03 -0.07 -0.05">
        <joint name="hip_r" type="hinge" axis="0 -1 0" range="-2 2"/>
        <joint name="slide_r" type="slide" axis="0.1 0 -1" range="-0.3 0.3" armature="0.02" damping="0.4"/>
        <inertial pos="0.02 0 -0.15" mass="0.4" diaginertia="0.005 0.004 0.001"/>
        <site name="right_sole" pos="0 0 -0.4"/>
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

/// The robot, its model's text `mjcf` written into `folder`; its plane is not looked for yet.
inline RobotDescription UnfoldedPlanarRobot(const TempFolder& folder, const std::string& mjcf) {
  RobotDescription robot;
  robot.name = "planar";
  robot.model = ReadMjcfModel(folder.Write("planar.xml", mjcf));
  robot.base = "base";
  robot.imu = "imu";
  robot.torso = "trunk";
  robot.com_height_m = 0.5;
  robot.base_height_m = 0.52;
  const Eigen::Matrix3Xd point = Eigen::Vector3d::Zero();
  robot.feet = {{"left", "left_sole", {}, point, 0.0}, {"right", "right_sole", {}, point, 0.0}};
  return robot;
}

inline RobotDescription PlanarRobot(const TempFolder& folder) {
  RobotDescription robot = UnfoldedPlanarRobot(folder, kPlanarMjcf);
  FindSagittalPlane(&robot);
  return robot;
}

}  // namespace sidestep
