// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/choose_motors.h"

#include <algorithm>
#include <cmath>

#include "models/import/text.h"
#include "models/robot_description/robot_figures.h"

namespace sidestep::importer {
namespace {

/// A group's figures over m g h, as generic_humanoid's are.
struct Ratios {
  const char* name;
  double stiffness;    // per rad
  double damping_s;    // of the servo
  double armature_s2;  // twice damping x 1 ms: half of what an explicit step bears
  double joint_damping_s;
  double effort;  // where the URDF's is no limit
  double posture_weight;
};
constexpr Ratios kLegs{"legs", 25.0, 0.0625, 1.25e-4, 0.0021, 0.5, 1.0};
constexpr Ratios kTorso{"torso", 25.0, 0.0625, 1.25e-4, 0.0021, 0.35, 1.0};
constexpr Ratios kArms{"arms", 0.83, 0.021, 6.25e-5, 0.00105, 0.15, 2.0};

constexpr double kMostEffort = 4.0;           // over m g h; no motor of a humanoid has more
constexpr double kMostVelocity_radps = 60.0;  // likewise: 570 turns a minute after the gear
constexpr double kVelocity = 3.5;             // over omega; shipped robots' legs have 8 to 12 rad/s

constexpr double kStep_s = 1e-3;          // of the physics that robots run in
constexpr double kStableShare = 0.5;      // of the damping that an explicit step bears
constexpr double kStableStiffness = 1.5;  // of armature / step^2, of which 4 is the end

class MotorChooser {
 public:
  MotorChooser(double gravity_Nm, double omega_radps, SourceRobot* robot)
      : gravity_Nm_(gravity_Nm),
        omega_radps_(omega_radps),
        robot_(*robot),
        tells_rotors_(TellsRotors(*robot)) {}

  /// Whether the servos of the source carry the robot on these joints.
  void JudgeServos(const std::vector<int>& joints) {
    for (const int joint : joints) {
      const double stiffness = Joint(joint).servo_stiffness_Nm_per_rad;
      softest_ = joint == joints.front() ? stiffness : std::min(softest_, stiffness);
    }
    has_servos_ = softest_ >= kStiffEnough * gravity_Nm_;
  }

  void Add(const Ratios& ratios, const std::vector<int>& joints) {
    if (joints.empty()) return;
    MotorGroup chosen;
    chosen.name = ratios.name;
    chosen.stiffness_Nm_per_rad = Rounded(ratios.stiffness * gravity_Nm_);
    chosen.damping_Nms_per_rad = Rounded(ratios.damping_s * gravity_Nm_);
    chosen.armature_kgm2 = Rounded(ratios.armature_s2 * gravity_Nm_);
    chosen.posture_weight = ratios.posture_weight;
    const bool has_damping = std::all_of(joints.begin(), joints.end(), [&](int joint) {
      return Joint(joint).damping_Nms_per_rad > 0.0;
    });
    if (!has_damping && !tells_rotors_) {
      chosen.joint_damping_Nms_per_rad = Rounded(ratios.joint_damping_s * gravity_Nm_);
    }
    const double least = std::min(ratios.stiffness, kStiffEnough) * gravity_Nm_;
    for (const int joint : joints) {
      Limit(ratios, &Joint(joint));
      const double tells_kgm2 = Joint(joint).armature_kgm2;
      if (tells_kgm2 > 0.0 && Bears(tells_kgm2) < least) {
        armatures_.push_back(Joint(joint).name);
        Joint(joint).armature_kgm2 = 0.0;
      }
      AddTo(GroupOf(chosen, Joint(joint)), joint);
    }
  }

  std::vector<MotorGroup> Finish(Notes* notes) {
    if (!efforts_.empty()) {
      notes->push_back("chose the torque limits of " + Listed(efforts_) + ": the " +
                       robot_.language + " has none or more than any motor has");
    }
    if (!velocities_.empty()) {
      notes->push_back("chose the velocity limits of " + Listed(velocities_) + ": the " +
                       robot_.language + " has none or more than any motor has");
    }
    if (!armatures_.empty()) {
      notes->push_back("chose the armatures of " + Listed(armatures_) + ": on the " +
                       robot_.language + "'s a servo that 1 ms bears doesn't hold the robot " +
                       "(a rotor's inertia counts by the square of the gear's ratio)");
    }
    TellServos(notes);
    return std::move(groups_);
  }

 private:
  /// The stiffest servo (Nm/rad) on such a rotor.
  static double Bears(double armature_kgm2) {
    return Rounded(kStableStiffness * armature_kgm2 / (kStep_s * kStep_s));
  }

  static bool TellsRotors(const SourceRobot& robot) {
    return std::any_of(robot.joints.begin(), robot.joints.end(),
                       [](const SourceJoint& joint) { return joint.armature_kgm2 > 0.0; });
  }

  /// `chosen`, with what the source tells of the joint in its stead.
  MotorGroup GroupOf(MotorGroup chosen, const SourceJoint& joint) const {
    if (joint.armature_kgm2 > 0.0) {
      // A heavier rotor on as stiff a servo swings on unless it is damped the more.
      const double heavier = std::max(1.0, joint.armature_kgm2 / chosen.armature_kgm2);
      chosen.damping_Nms_per_rad = Rounded(chosen.damping_Nms_per_rad * std::sqrt(heavier));
      chosen.armature_kgm2 = joint.armature_kgm2;
    }
    if (has_servos_ && joint.servo_stiffness_Nm_per_rad > 0.0) {
      chosen.stiffness_Nm_per_rad = joint.servo_stiffness_Nm_per_rad;
      if (joint.servo_damping_Nms_per_rad > 0.0)
        chosen.damping_Nms_per_rad = joint.servo_damping_Nms_per_rad;
    }
    if (joint.armature_kgm2 <= 0.0 && !has_servos_) return chosen;
    const double per_step = chosen.armature_kgm2 / kStep_s;
    chosen.damping_Nms_per_rad =
        std::min(chosen.damping_Nms_per_rad, Rounded(kStableShare * per_step));
    chosen.stiffness_Nm_per_rad =
        std::min(chosen.stiffness_Nm_per_rad, Bears(chosen.armature_kgm2));
    return chosen;
  }

  void AddTo(MotorGroup group, int joint) {
    const auto same = std::find_if(groups_.begin(), groups_.end(), [&](const MotorGroup& other) {
      return other.name == group.name && other.armature_kgm2 == group.armature_kgm2 &&
             other.stiffness_Nm_per_rad == group.stiffness_Nm_per_rad &&
             other.damping_Nms_per_rad == group.damping_Nms_per_rad;
    });
    MotorGroup& to = same == groups_.end() ? groups_.emplace_back(std::move(group)) : *same;
    to.joints.push_back(joint);
  }

  SourceJoint& Joint(int joint) { return robot_.joints[static_cast<std::size_t>(joint)]; }

  void Limit(const Ratios& ratios, SourceJoint* joint) {
    if (joint->effort_Nm <= 0.0 || joint->effort_Nm > kMostEffort * gravity_Nm_) {
      const double was = joint->effort_Nm;
      joint->effort_Nm = Rounded(ratios.effort * gravity_Nm_, 2);
      AddNote("effort was " + Figure(was) + ": chosen from the robot's weight", joint);
      efforts_.push_back(joint->name);
    }
    if (joint->velocity_radps <= 0.0 || joint->velocity_radps > kMostVelocity_radps) {
      const double was = joint->velocity_radps;
      joint->velocity_radps = Rounded(kVelocity * omega_radps_, 2);
      AddNote("velocity was " + Figure(was) + ": chosen", joint);
      velocities_.push_back(joint->name);
    }
  }

  void TellServos(Notes* notes) const {
    if (has_servos_) {
      notes->push_back(
          "took the servos of the MJCF's position actuators, no stiffer than a step of 1 ms bears");
    } else if (softest_ > 0.0) {
      notes->push_back("chose stiffer servos than the MJCF's position actuators, whose " +
                       Figure(softest_) + " Nm/rad are less than " + Figure(kStiffEnough) +
                       " m g h (" + Figure(kStiffEnough * gravity_Nm_) + " Nm/rad)");
    }
  }

  static void AddNote(const std::string& note, SourceJoint* joint) {
    joint->note += (joint->note.empty() ? "" : "; ") + note;
  }

  double gravity_Nm_;
  double omega_radps_;
  SourceRobot& robot_;
  bool tells_rotors_;
  bool has_servos_{false};
  double softest_{0.0};  // stiffness of the legs' servos in the source
  std::vector<MotorGroup> groups_;
  std::vector<std::string> efforts_, velocities_, armatures_;
};

}  // namespace

std::vector<MotorGroup> ChooseMotors(const BodyPlan& plan, double gravity_Nm, double omega_radps,
                                     SourceRobot* robot, Notes* notes) {
  MotorChooser chooser(gravity_Nm, omega_radps, robot);
  std::vector<int> legs, arms;
  for (const Limb& leg : plan.legs) legs.insert(legs.end(), leg.joints.begin(), leg.joints.end());
  for (const Limb& arm : plan.arms) arms.insert(arms.end(), arm.joints.begin(), arm.joints.end());
  chooser.JudgeServos(legs);
  chooser.Add(kLegs, legs);
  chooser.Add(kTorso, plan.torso_joints);
  chooser.Add(kArms, arms);
  return chooser.Finish(notes);
}

}  // namespace sidestep::importer
