// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/choose_motors.h"

#include <algorithm>

#include "models/import/text.h"

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
constexpr double kVelocity_radps = 12.0;      // of shipped robots' legs: 8 to 12

class MotorChooser {
 public:
  MotorChooser(double gravity_Nm, SourceRobot* robot) : gravity_Nm_(gravity_Nm), robot_(*robot) {}

  void Add(const Ratios& ratios, const std::vector<int>& joints) {
    if (joints.empty()) return;
    MotorGroup group;
    group.name = ratios.name;
    group.joints = joints;
    group.stiffness_Nm_per_rad = Rounded(ratios.stiffness * gravity_Nm_);
    group.damping_Nms_per_rad = Rounded(ratios.damping_s * gravity_Nm_);
    group.armature_kgm2 = Rounded(ratios.armature_s2 * gravity_Nm_);
    group.posture_weight = ratios.posture_weight;
    const bool has_damping = std::all_of(joints.begin(), joints.end(), [&](int joint) {
      return Joint(joint).damping_Nms_per_rad > 0.0;
    });
    if (!has_damping) {
      group.joint_damping_Nms_per_rad = Rounded(ratios.joint_damping_s * gravity_Nm_);
    }
    for (const int joint : joints) Limit(ratios, &Joint(joint));
    groups_.push_back(std::move(group));
  }

  std::vector<MotorGroup> Finish(Notes* notes) {
    if (!efforts_.empty()) {
      notes->push_back("chose the torque limits of " + Listed(efforts_) +
                       ": the URDF has none or more than any motor has");
    }
    if (!velocities_.empty()) {
      notes->push_back("chose the velocity limits of " + Listed(velocities_) +
                       ": the URDF has none or more than any motor has");
    }
    return std::move(groups_);
  }

 private:
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
      joint->velocity_radps = kVelocity_radps;
      AddNote("velocity was " + Figure(was) + ": chosen", joint);
      velocities_.push_back(joint->name);
    }
  }

  static void AddNote(const std::string& note, SourceJoint* joint) {
    joint->note += (joint->note.empty() ? "" : "; ") + note;
  }

  double gravity_Nm_;
  SourceRobot& robot_;
  std::vector<MotorGroup> groups_;
  std::vector<std::string> efforts_, velocities_;
};

}  // namespace

std::vector<MotorGroup> ChooseMotors(const BodyPlan& plan, double gravity_Nm, SourceRobot* robot,
                                     Notes* notes) {
  MotorChooser chooser(gravity_Nm, robot);
  std::vector<int> legs, arms;
  for (const Limb& leg : plan.legs) legs.insert(legs.end(), leg.joints.begin(), leg.joints.end());
  for (const Limb& arm : plan.arms) arms.insert(arms.end(), arm.joints.begin(), arm.joints.end());
  chooser.Add(kLegs, legs);
  chooser.Add(kTorso, plan.torso_joints);
  chooser.Add(kArms, arms);
  return chooser.Finish(notes);
}

}  // namespace sidestep::importer
