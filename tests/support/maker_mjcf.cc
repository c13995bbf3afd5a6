// SPDX-License-Identifier: BSD-3-Clause
#include "tests/support/maker_mjcf.h"

#include <fstream>
#include <sstream>
#include <vector>

namespace sidestep {
namespace {

/// A joint and what moves it.
struct Motor {
  std::string joint;
  double limit_Nm;
};

class MjcfWriter {
 public:
  explicit MjcfWriter(const MakerMjcf& robot) : robot_(robot) {}

  std::string Write() {
    out_ << "<mujoco model=\"maker\">\n<compiler angle=\"degree\" autolimits=\"true\"/>\n";
    WriteDefaults();
    out_ << "<asset><material name=\"grey\" rgba=\".6 .6 .6 1\"/></asset>\n<worldbody>\n";
    WriteTrunk();
    out_ << "</worldbody>\n";
    WriteActuators();
    out_ << "</mujoco>\n";
    return out_.str();
  }

 private:
  const char* Newer(const char* words) const { return robot_.has_newer_words ? words : ""; }

  void WriteDefaults() {
    out_ << "<default><default class=\"maker\">\n"
         << "<joint type=\"hinge\" armature=\"" << robot_.armature_kgm2 << "\" damping=\"0.6\""
         << Newer(" actuatorfrcrange=\"-180 180\"") << "/>\n"
         << "<motor ctrlrange=\"-200 200\"/>\n"
         << "<position kp=\"9000\" forcerange=\"-200 200\""
         << Newer(" kv=\"18\" inheritrange=\"1\"") << "/>\n"
         << "<default class=\"visual\"><geom contype=\"0\" conaffinity=\"0\" group=\"2\" "
            "material=\"grey\" mass=\"0\"/></default>\n"
         << "<default class=\"collision\"><geom group=\"3\" mass=\"0\"/></default>\n"
         << "</default></default>\n";
  }

  /// A homogeneous box, seen and touched.
  void Inertial(double kg, const char* com, double x, double y, double z) {
    out_ << "<inertial pos=\"" << com << "\" mass=\"" << kg << "\" diaginertia=\""
         << kg / 12 * (y * y + z * z) << " " << kg / 12 * (x * x + z * z) << " "
         << kg / 12 * (x * x + y * y) << "\"/>\n";
    for (const char* shape : {"visual", "collision"}) {
      out_ << "<geom class=\"" << shape << "\" type=\"box\" pos=\"" << com << "\" size=\""
           << 0.5 * x << " " << 0.5 * y << " " << 0.5 * z << "\"/>\n";
    }
  }

  void Joint(const std::string& name, const char* axis, const char* range, double limit_Nm,
             const char* pos = "0 0 0") {
    out_ << "<joint name=\"" << name << "\" axis=\"" << axis << "\" range=\"" << range
         << "\" pos=\"" << pos << "\"/>\n";
    motors_.push_back({name, limit_Nm});
  }

  void WriteTrunk() {
    out_ << "<body name=\"pelvis\" pos=\"0 0 0.9\" childclass=\"maker\">\n"
         << (robot_.is_fixed ? "" : "<freejoint/>\n");
    Inertial(9, "0 0 0.02", 0.16, 0.22, 0.12);
    out_ << Newer("<frame pos=\"0.02 0 0.05\" euler=\"0 0 0\">") << "<site name=\"imu\"/>"
         << Newer("</frame>") << "\n<camera name=\"eye\" pos=\"1 0 0\"/>\n";
    for (const bool is_left : {true, false}) Leg(is_left ? "left" : "right", is_left ? 1 : -1);
    out_ << "<body name=\"trunk\" pos=\"0 0 0.1\">\n";
    Joint("waist_yaw", "0 0 1", "-70 70", 80);
    Inertial(18, "0 0 0.2", 0.18, 0.28, 0.4);
    if (robot_.has_head) {
      out_ << "<body name=\"head\" pos=\"0 0 0.44\">\n";
      Joint("neck", "0 1 0", "-30 30", 10);
      Inertial(3, "0 0 0.1", 0.16, 0.14, 0.2);
      out_ << "</body>\n";
    }
    for (const bool is_left : {true, false}) Arm(is_left ? "left" : "right", is_left ? 1 : -1);
    out_ << "</body></body>\n";
  }

  void Leg(const std::string& side, int sign) {
    const char* yaw = "-40 40";
    const char* roll = sign > 0 ? "-25 40" : "-40 25";
    out_ << "<body name=\"" << side << "_hip\" pos=\"0 " << 0.09 * sign << " -0.05\">\n";
    Joint(side + "_hip_yaw", "0 0 1", yaw, 100);
    if (!robot_.shares_hips) {
      Inertial(1.2, "0 0 0", 0.08, 0.08, 0.08);
      out_ << "<body name=\"" << side << "_hip_2\">\n";
    }
    Joint(side + "_hip_roll", "1 0 0", roll, 150);
    if (!robot_.shares_hips) {
      Inertial(1.2, "0 0 0", 0.08, 0.08, 0.08);
      out_ << "<body name=\"" << side << "_thigh\">\n";
    }
    Joint(side + "_hip_pitch", "0 1 0", "-110 60", 180, robot_.shares_hips ? "0 0 -0.01" : "0 0 0");
    Inertial(robot_.shares_hips ? 5.4 : 3.0, "0.005 0 -0.18", 0.12, 0.11, 0.28);
    out_ << "<body name=\"" << side << "_shank\" pos=\"0 0 -0.38\">\n";
    Joint(side + "_knee", "0 1 0", "0 130", 200);
    Inertial(2.2, "0 0 -0.17", 0.09, 0.09, 0.28);
    Foot(side);
    out_ << (robot_.shares_hips ? "</body></body>\n" : "</body></body></body></body>\n");
  }

  void Foot(const std::string& side) {
    out_ << "<body name=\"" << side << "_foot\" pos=\"0 0 -0.38\">\n";
    Joint(side + "_ankle_pitch", "0 1 0", "-60 45", 120);
    if (!robot_.shares_hips) {
      out_ << "<inertial pos=\"0 0 0\" mass=\"0.3\" diaginertia=\"3e-4 3e-4 3e-4\"/>\n<body name=\""
           << side << "_sole_link\">\n";
    }
    Joint(side + "_ankle_roll", "1 0 0", "-30 30", 90, robot_.shares_hips ? "0 0 -0.02" : "0 0 0");
    out_ << "<inertial pos=\"0.03 0 -0.04\" mass=\"0.9\" diaginertia=\"1e-3 3.6e-3 4e-3\"/>\n";
    if (robot_.foot == MjcfFoot::kBoxes) {
      out_ << "<geom class=\"collision\" type=\"box\" size=\"0.11 0.05 0.02\" pos=\"0.03 0 "
              "-0.05\"/>\n";
    } else if (robot_.foot == MjcfFoot::kBalls) {
      for (const char* at : {"0.13 0.04", "0.13 -0.04", "-0.07 0.04", "-0.07 -0.04"}) {
        out_ << "<geom class=\"collision\" size=\"0.01\" pos=\"" << at << " -0.06\"/>\n";
      }
    } else {
      for (const char* y : {"0.04", "-0.04"}) {
        out_ << "<geom class=\"collision\" type=\"capsule\" size=\"0.015\" fromto=\"-0.07 " << y
             << " -0.055 0.13 " << y << " -0.055\"/>\n";
      }
    }
    out_ << "<site name=\"" << side << "_sole\" pos=\"0.03 0 -0.07\"/>\n"
         << (robot_.shares_hips ? "</body>\n" : "</body></body>\n");
  }

  void Arm(const std::string& side, int sign) {
    out_ << "<body name=\"" << side << "_shoulder\" pos=\"0 " << 0.19 * sign << " 0.36\">\n";
    Joint(side + "_shoulder_pitch", "0 1 0", "-150 60", 50);
    Inertial(0.8, "0 0 0", 0.07, 0.07, 0.07);
    out_ << "<body name=\"" << side << "_upper_arm\">\n";
    Joint(side + "_shoulder_roll", "1 0 0", sign > 0 ? "-15 150" : "-150 15", 50);
    Inertial(1.4, "0 0 -0.13", 0.07, 0.07, 0.24);
    out_ << "<body name=\"" << side << "_forearm\" pos=\"0 0 -0.27\">\n";
    Joint(side + "_elbow", "0 1 0", "-130 0", 40);
    Inertial(1.1, "0 0 -0.11", 0.06, 0.06, 0.22);
    out_ << "</body></body></body>\n";
  }

  void WriteActuators() {
    out_ << "<actuator>\n";
    for (const Motor& motor : motors_) {
      const std::string names =
          " class=\"maker\" name=\"" + motor.joint + "\" joint=\"" + motor.joint + "\"";
      if (robot_.actuators == MjcfActuators::kMotors) {
        out_ << "<motor" << names << " ctrlrange=\"-1 1\" gear=\"" << motor.limit_Nm << "\"/>\n";
      } else if (robot_.actuators == MjcfActuators::kPositions) {
        out_ << "<position" << names << "/>\n";
      } else {
        out_ << "<general" << names
             << " gainprm=\"9000\" biastype=\"affine\" biasprm=\"0 -9000 "
                "-18\" forcerange=\"-"
             << motor.limit_Nm << " " << motor.limit_Nm << "\"/>\n";
      }
    }
    out_ << "</actuator>\n";
  }

  MakerMjcf robot_;
  std::ostringstream out_;
  std::vector<Motor> motors_;
};

constexpr char kSceneTail[] = R"(
  <statistic center="0 0 0.7"/>
  <option timestep="0.002" integrator="implicit"/>
  <visual><global azimuth="120"/><quality shadowsize="2048"/></visual>
  <asset>
    <texture type="skybox" builtin="gradient" width="32" height="192"/>
    <texture name="grid" type="2d" builtin="checker" width="32" height="32"/>
    <material name="grid" texture="grid" reflectance=".2"/>
  </asset>
  <worldbody>
    <light pos="0 0 4"/>
    <geom name="floor" type="plane" size="0 0 .05" material="grid"/>
    <body name="crate" pos="2 0 .2"><freejoint/><geom type="box" size=".2 .2 .2"/></body>
  </worldbody>
  <keyframe><key name="home" qpos="0 0 1"/></keyframe>
</mujoco>
)";

}  // namespace

std::string RobotMjcf(const MakerMjcf& robot) { return MjcfWriter(robot).Write(); }

std::filesystem::path WriteMakerMjcf(const MakerMjcf& robot, const std::string& name,
                                     const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder / "parts");
  std::ofstream(folder / "parts/robot.xml") << RobotMjcf(robot);
  std::filesystem::path scene = folder / (name + ".xml");
  std::ofstream(scene) << "<mujoco model=\"" << name << "\">\n  <include file=\"parts/robot.xml\"/>"
                       << kSceneTail;
  return scene;
}

}  // namespace sidestep
