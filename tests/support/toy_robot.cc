// SPDX-License-Identifier: BSD-3-Clause
#include "tests/support/toy_robot.h"

#include <fstream>
#include <string>

namespace sidestep::testing {
namespace {

constexpr const char* kToyLeg = R"(
      <body name="%-thigh" pos="0 @ 0">
        <joint name="%_hip_roll" axis="1 0 0"/><joint name="%_hip_pitch" axis="0 1 0"/>
        <geom type="capsule" fromto="0 0 0 0 0 -0.24" size="0.03" mass="1" rgba="0.2 0.3 0.4 1"/>
        <body name="%-shin" pos="0 0 -0.24">
          <joint name="%_knee" axis="0 1 0"/>
          <geom type="capsule" fromto="0 0 0 0 0 -0.24" size="0.025" mass="1"
                rgba="0.9 0.9 0.92 1"/>
          <geom type="box" size="0.08 0.04 0.01" pos="0.02 0 -0.25" mass="0.5"
                rgba="0.2 0.22 0.25 1" contype="1" conaffinity="1"/>
          <site name="%" pos="0 0 -0.26"/>
        </body>
      </body>)";

std::string Replaced(std::string text, const std::string& what, const std::string& with) {
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += with.size()) {
    text.replace(at, what.size(), with);
  }
  return text;
}

std::string ToyMjcf() {
  const auto leg = [](const std::string& name, const std::string& y) {
    return Replaced(Replaced(kToyLeg, "%", name), "@", y);
  };
  return R"(<mujoco model="toy">
  <default><geom contype="0" conaffinity="0"/></default>
  <worldbody>
    <body name="trunk" pos="0 0 0.52"><freejoint/>
      <geom type="box" size="0.07 0.11 0.14" pos="0 0 0.17" mass="15" rgba="0.9 0.9 0.92 1"/>
      <geom type="sphere" size="0.07" pos="0.01 0 0.40" mass="1" rgba="0.2 0.3 0.4 1"/>
      <site name="imu"/>)" +
         leg("left", "0.08") + leg("right", "-0.08") + R"(
    </body>
  </worldbody>
  <actuator>
    <motor joint="left_hip_roll"/><motor joint="left_hip_pitch"/><motor joint="left_knee"/>
    <motor joint="right_hip_roll"/><motor joint="right_hip_pitch"/><motor joint="right_knee"/>
  </actuator>
  <sensor>
    <framequat name="imu_orientation" objtype="site" objname="imu"/>
    <gyro name="imu_gyro" site="imu"/><accelerometer name="imu_accelerometer" site="imu"/>
    <touch name="left_touch" site="left"/><touch name="right_touch" site="right"/>
  </sensor>
</mujoco>
)";
}

constexpr const char* kToyRobot = R"(sidestep_robot: 1
name: toy
mjcf: toy.xml
base: trunk
imu: imu
com_height_m: 0.5714
base_height_m: 0.5
feet:
  - {name: left, frame: left, sole_height_m: 0.0, vertices_m: [[0, 0, 0]]}
  - {name: right, frame: right, sole_height_m: 0.0, vertices_m: [[0, 0, 0]]}
)";

}  // namespace

RobotDescription WriteToyRobot(const std::filesystem::path& dir) {
  std::filesystem::create_directories(dir);
  std::ofstream(dir / "toy.xml") << ToyMjcf();
  std::ofstream(dir / "robot.yaml") << kToyRobot;
  return ReadRobotDescription(dir / "robot.yaml");
}

}  // namespace sidestep::testing
