// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/write_robot_yaml.h"

#include <cmath>
#include <sstream>

#include "models/import/control_text.h"
#include "models/import/text.h"
#include "models/support/plain_word.h"

namespace sidestep::importer {
namespace {

constexpr int kPoseDigits = 12;
constexpr std::size_t kLineLength = 116;
constexpr double kZeroAngle = 1e-12;

/// `[a, b, c]`, broken into lines that begin with `indent`.
std::string List(const std::vector<std::string>& names, const std::string& indent) {
  std::string text = "[", line;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string word = YamlText(names[i]) + (i + 1 < names.size() ? ", " : "]");
    if (line.size() + word.size() + indent.size() > kLineLength) {
      text += line + "\n" + indent;
      line.clear();
    }
    line += word;
  }
  if (names.empty()) return "[]";
  text += line;
  for (std::size_t at = text.find(" \n"); at != std::string::npos; at = text.find(" \n")) {
    text.erase(at, 1);
  }
  return text;
}

class YamlWriter {
 public:
  explicit YamlWriter(const ImportedRobot& imported) : it_(imported) {}

  std::string Write() {
    WriteHead();
    WriteHome();
    WriteJoints();
    WriteSensorsAndFeet();
    WriteSelfCollision();
    out_ << ControlText(it_);
    return out_.str();
  }

 private:
  void WriteHead() {
    out_ << "# " << it_.name << ", imported from " << it_.source
         << ". Lines with `decide:` need a person who knows the robot.\n"
         << "sidestep_robot: 1\nname: " << it_.name
         << "\nurdf: robot.urdf\nbase: " << YamlText(it_.Link(it_.robot.root))
         << "\nimu: " << YamlText(it_.imu) << "\ntorso: " << YamlText(it_.torso)
         << "\ncom_height_m: " << Figure(it_.start.com_height_m, 6) << "\n\n";
  }

  void WriteHome() {
    const Eigen::Isometry3d& X_WR = it_.start.posture.X_WR;
    out_ << (it_.plan.stands_on_points() ? "# The start, solved: feet "
                                         : "# The start, solved: soles flat and ")
         << Figure(it_.start.step_width_m, 3)
         << " m apart, CoM over their middle, trunk as at zero, legs at "
         << Figure(100.0 * it_.start.stretch, 3) << " % of their length.\n"
         << "base_height_m: " << Figure(X_WR.translation().z(), kPoseDigits) << "\n";
    if (it_.plan.facing_rad != 0.0) {
      out_ << "base_rpy_rad: [0, 0, " << Figure(-it_.plan.facing_rad, kPoseDigits) << "]\n";
    }
    out_ << "home:\n";
    for (const int joint : it_.plan.Actuated()) {
      const double q = it_.start.posture.q[joint];
      if (std::abs(q) < kZeroAngle) continue;
      out_ << "  " << YamlText(it_.Joint(joint)) << ": " << Figure(q, kPoseDigits) << "\n";
    }
    if (!it_.plan.locked.empty()) {
      out_ << "\n# All joints that `joints` does not name are welded at zero: "
           << it_.plan.locked.size() << " of them.\nlocked: rest\n";
    }
  }

  std::vector<std::string> NamesOf(const std::vector<int>& joints) const {
    std::vector<std::string> names;
    for (const int joint : joints) names.push_back(it_.Joint(joint));
    return names;
  }

  void WriteJoints() {
    out_ << "\n# Limits of torque and velocity are the URDF's. m g h = "
         << Figure(it_.mass_kg * 9.81 * it_.start.com_height_m, 3)
         << " Nm: where servos are chosen, they are by it.\n";
    if (it_.LacksArmature()) {
      out_
          << "# decide: armature_kgm2 (rotor's inertia times the gear ratio squared) is not in the "
          << it_.robot.language
          << ": chosen so\n# that the servo's damping times 1 ms is half of it.\n";
    }
    out_ << "joints:\n";
    for (const MotorGroup& group : it_.motors) {
      out_ << "  - names: " << List(NamesOf(group.joints), "            ") << "  # " << group.name
           << "\n    armature_kgm2: " << Figure(group.armature_kgm2) << "\n";
      if (group.joint_damping_Nms_per_rad > 0.0) {
        out_ << "    damping_Nms_per_rad: " << Figure(group.joint_damping_Nms_per_rad) << "\n";
      }
      out_ << "    servo_stiffness_Nm_per_rad: " << Figure(group.stiffness_Nm_per_rad)
           << "\n    servo_damping_Nms_per_rad: " << Figure(group.damping_Nms_per_rad)
           << "\n    posture_weight: " << Figure(group.posture_weight) << "\n";
    }
  }

  void WriteSensorsAndFeet() {
    out_ << "\n# decide: sensors that the robot lacks are made up: one in each "
            "ankle.\nforce_torque:\n";
    for (const Foot& foot : it_.feet) {
      out_ << "  - {name: " << YamlText(it_.Link(foot.force_torque)) << "}\n";
    }
    out_ << "\nfeet:\n";
    for (std::size_t side = 0; side < 2; ++side) {
      const Foot& foot = it_.feet[side];
      if (foot.is_guessed) out_ << "# decide: this sole is a guess; measure the foot's.\n";
      if (foot.ball_radius_m > 0.0) {
        WritePointFoot(foot, side);
        continue;
      }
      out_ << "  - name: " << (side == 0 ? "left" : "right") << "  # sole of "
           << Figure(foot.sole.length_m, 3) << " m x " << Figure(foot.sole.width_m, 3)
           << " m, found in the " << foot.found_in
           << "\n    frame: " << YamlText(it_.Link(foot.frame)) << "\n    force_torque: ["
           << YamlText(it_.Link(foot.force_torque)) << "]\n    vertices_m: [";
      for (Eigen::Index i = 0; i < foot.vertices_m.cols(); ++i) {
        out_ << (i > 0 ? ", [" : "[") << Figure(foot.vertices_m(0, i)) << ", "
             << Figure(foot.vertices_m(1, i)) << ", 0]";
      }
      out_ << "]\n";
    }
  }

  void WritePointFoot(const Foot& foot, std::size_t side) {
    out_ << "  - name: " << (side == 0 ? "left" : "right") << "  # a ball, found in the "
         << foot.found_in << "\n    frame: " << YamlText(it_.Link(foot.frame))
         << "\n    sole_height_m: " << Figure(foot.ball_radius_m, kPoseDigits)
         << "\n    force_torque: [" << YamlText(it_.Link(foot.force_torque))
         << "]\n    vertices_m: [[0, 0, 0]]\n";
  }

  void WriteSelfCollision() {
    if (it_.self_collision.empty()) return;
    out_ << "\n# Links that can touch within their joints' ranges and don't at the start.\n"
            "self_collision:\n";
    for (const CollisionPairs& pairs : it_.self_collision) {
      out_ << "  - [" << List(pairs.first, "     ") << ", " << List(pairs.second, "     ") << "]\n";
    }
  }

  const ImportedRobot& it_;
  std::ostringstream out_;
};

}  // namespace

std::string YamlText(const std::string& name) {
  const bool has_letter = name.find_first_not_of("0123456789.-_eExX") != std::string::npos;
  const bool is_word = name == "true" || name == "false" || name == "null" || name == "yes" ||
                       name == "no" || name == "on" || name == "off";
  if (IsPlainWord(name) && has_letter && !is_word) return name;
  std::string quoted = "'";
  for (const char c : name) quoted += c == '\'' ? "''" : std::string(1, c);
  return quoted + "'";
}

std::string RobotYamlText(const ImportedRobot& imported) { return YamlWriter(imported).Write(); }

}  // namespace sidestep::importer
