// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/clean_up.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "models/import/posture.h"
#include "models/import/text.h"
#include "models/support/require.h"

namespace sidestep::importer {
namespace {

constexpr double kLightShare = 0.005;    // of the robot's mass: sensors and frames
constexpr double kMadeUpMass_kg = 0.01;  // of a moving link without one: its rotor's armature rules
constexpr double kLeastMoment = 0.01;    // a principal moment over the largest
constexpr double kNoInertia = 1e-3;      // over a ball's: it was left at zero
constexpr double kWater_kgpm3 = 1000.0;
constexpr double kHeadroom = 1.0 + 1e-6;

/// Of a homogeneous ball as heavy as water.
Eigen::Matrix3d BallInertia(double mass_kg) {
  const double radius_m = std::cbrt(3.0 * mass_kg / (4.0 * std::numbers::pi * kWater_kgpm3));
  return 0.4 * mass_kg * radius_m * radius_m * Eigen::Matrix3d::Identity();
}

class Cleaner {
 public:
  Cleaner(SourceRobot* robot, Problems* problems, Notes* notes)
      : robot_(*robot), problems_(*problems), notes_(*notes) {}

  void Run() {
    light_kg_ = kLightShare * TotalMass_kg(robot_);
    MoveRoot();
    for (SourceJoint& joint : robot_.joints) FixIfMimic(&joint);
    for (std::size_t i = robot_.order.size(); i-- > 1;) {
      GiveMass(robot_.order[i]);  // children before parents
    }
    for (std::size_t i = robot_.order.size(); i-- > 0;) {
      CheckInertia(robot_.order[i]);
    }
    if (!lumped_.empty()) {
      notes_.push_back("made point masses of " + Listed(lumped_) +
                       ": a few grams without a possible inertia");
    }
    std::reverse(mended_.begin(), mended_.end());
    notes_.insert(notes_.end(), mended_.begin(), mended_.end());
    if (!mimics_.empty()) {
      notes_.push_back("fixed " + Listed(mimics_) + ", which mimic other joints");
    }
    if (!emptied_.empty()) {
      notes_.push_back("fixed " + Listed(emptied_) + ", which move nothing with mass");
    }
  }

 private:
  SourceLink& Link(int link) { return robot_.links[static_cast<std::size_t>(link)]; }
  SourceJoint* Above(int link) {
    const int joint = robot_.joint_above[static_cast<std::size_t>(link)];
    return joint < 0 ? nullptr : &robot_.joints[static_cast<std::size_t>(joint)];
  }

  /// The base is the first link with mass: a root without one changes places with its heaviest
  /// fixed child.
  void MoveRoot() {
    while (!Link(robot_.root).has_mass()) {
      int heaviest = -1;
      double most_kg = 0.0;
      for (const int joint : robot_.joints_below[static_cast<std::size_t>(robot_.root)]) {
        const SourceJoint& below = robot_.joints[static_cast<std::size_t>(joint)];
        const double mass_kg = SubtreeMass_kg(robot_, below.child);
        if (below.is_moving() || mass_kg <= most_kg) continue;
        heaviest = joint;
        most_kg = mass_kg;
      }
      if (heaviest < 0) {
        problems_.Add(Link(robot_.root).place, "the root '" + Link(robot_.root).name +
                                                   "' has no mass, nor has what is fixed to it");
        problems_.ThrowIfAny();
      }
      SourceJoint& joint = robot_.joints[static_cast<std::size_t>(heaviest)];
      notes_.push_back("made '" + Link(joint.child).name + "' the root: '" +
                       Link(joint.parent).name + "' above it has no mass");
      std::swap(joint.parent, joint.child);
      joint.X_PC = joint.X_PC.inverse();
      joint.note = "turned round: the root must have mass";
      const std::string fault = ConnectLinks(&robot_);
      SIDESTEP_REQUIRE(fault.empty(), fault);
    }
  }

  void FixIfMimic(SourceJoint* joint) {
    if (!joint->is_mimic || !joint->is_moving()) return;
    mimics_.push_back(joint->name);
    joint->kind = JointKind::kFixed;
    joint->note = "was a joint that mimics another; fixed at zero";
  }

  void GiveMass(int index) {
    SourceLink& link = Link(index);
    SourceJoint* joint = Above(index);
    if (link.has_mass() || !joint->is_moving()) return;
    if (SubtreeMass_kg(robot_, index) <= 0.0) {
      emptied_.push_back(joint->name);
      joint->kind = JointKind::kFixed;
      joint->note = "moved nothing with mass; fixed at zero";
      return;
    }
    link.mass.mass_kg = kMadeUpMass_kg;
    link.mass.inertia_kgm2 = BallInertia(kMadeUpMass_kg);
    link.note = "had no mass, but moves: given " + Figure(kMadeUpMass_kg * 1e3) + " g";
    notes_.push_back("gave link '" + link.name + "' " + Figure(kMadeUpMass_kg * 1e3) +
                     " g: it moves and has no mass");
  }

  void CheckInertia(int index) {
    SourceLink& link = Link(index);
    if (!link.has_mass() || IsPhysical(link.mass)) return;
    SourceJoint* joint = Above(index);
    if (joint != nullptr && !joint->is_moving() && link.mass.mass_kg <= light_kg_ &&
        Link(joint->parent).has_mass()) {
      LumpInto(*joint, &link);
    } else {
      MendInertia(&link);
    }
  }

  void LumpInto(const SourceJoint& joint, SourceLink* link) {
    SourceLink& parent = Link(joint.parent);
    const Eigen::Vector3d at_m = joint.X_PC * link->mass.com_m;
    const MassProperties whole = parent.mass;
    MassProperties& sum = parent.mass;
    sum.mass_kg = whole.mass_kg + link->mass.mass_kg;
    sum.com_m = (whole.mass_kg * whole.com_m + link->mass.mass_kg * at_m) / sum.mass_kg;
    const auto point = [](double mass_kg, const Eigen::Vector3d& arm) -> Eigen::Matrix3d {
      return mass_kg * (arm.squaredNorm() * Eigen::Matrix3d::Identity() - arm * arm.transpose());
    };
    sum.inertia_kgm2 = whole.inertia_kgm2 + point(whole.mass_kg, whole.com_m - sum.com_m) +
                       point(link->mass.mass_kg, at_m - sum.com_m);
    link->note = "its " + Figure(link->mass.mass_kg * 1e3) + " g are a point mass of '" +
                 parent.name + "' now";
    link->mass = MassProperties();
    lumped_.push_back(link->name);
  }

  /// Raises the smaller principal moments as far as they must be; without any, takes a ball's.
  void MendInertia(SourceLink* link) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(link->mass.inertia_kgm2);
    const Eigen::Vector3d was = solver.eigenvalues();  // ascending
    const Eigen::Matrix3d ball = BallInertia(link->mass.mass_kg);
    const std::string numbers = "principal moments " + Figure(was(0)) + ", " + Figure(was(1)) +
                                ", " + Figure(was(2)) + " kg m^2 of " + Figure(link->mass.mass_kg) +
                                " kg, which no body has";
    if (was(2) < kNoInertia * ball(0, 0)) {
      link->mass.inertia_kgm2 = ball;
      link->note = "had " + numbers + ": given those of a ball as heavy as water";
    } else {
      Eigen::Vector3d moments = was.cwiseMax(kLeastMoment * was(2));
      const double lacks = moments(2) * kHeadroom - moments(0) - moments(1);
      if (lacks > 0.0) moments.head<2>().array() += 0.5 * lacks;
      link->mass.inertia_kgm2 =
          solver.eigenvectors() * moments.asDiagonal() * solver.eigenvectors().transpose();
      link->note = "had " + numbers + ": the smaller ones were raised";
    }
    mended_.push_back("line " + std::to_string(link->place.line) + ": link '" + link->name + "' " +
                      link->note);
  }

  SourceRobot& robot_;
  Problems& problems_;
  Notes& notes_;
  double light_kg_{0.0};
  std::vector<std::string> lumped_, mended_, mimics_, emptied_;
};

}  // namespace

void CleanUp(SourceRobot* robot, Problems* problems, Notes* notes) {
  Cleaner(robot, problems, notes).Run();
}

}  // namespace sidestep::importer
