// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/mjcf_motors.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "models/import/text.h"
#include "models/mjcf/joint_servo.h"

namespace sidestep::importer {
namespace {

constexpr double kUnbound = std::numeric_limits<double>::infinity();

class MotorTaker {
 public:
  MotorTaker(const mjModel& model, MjcfBodies* bodies) : m_(model), bodies_(*bodies) {}

  void Take(Notes* notes) {
    std::vector<double> limits(bodies_.robot.joints.size(), 0.0);
    for (int i = 0; i < m_.nu; ++i) {
      const int index = bodies_.joint[static_cast<std::size_t>(m_.actuator_trnid[2 * i])];
      if (index < 0) continue;
      SourceJoint& joint = bodies_.robot.joints[static_cast<std::size_t>(index)];
      limits[static_cast<std::size_t>(index)] += JointEffortLimit_Nm(m_, i);
      TakeServo(i, &joint);
    }
    for (int id = 0; id < m_.njnt; ++id) {
      const int index = bodies_.joint[static_cast<std::size_t>(id)];
      if (index < 0) continue;
      SourceJoint& joint = bodies_.robot.joints[static_cast<std::size_t>(index)];
      double limit = limits[static_cast<std::size_t>(index)];
      if (limit == 0.0) {
        idle_.push_back(joint.name);
        limit = kUnbound;
      }
      limit = std::min(limit, JointLimitOf(id));
      joint.effort_Nm = std::isfinite(limit) ? limit : 0.0;
    }
    if (!idle_.empty()) notes->push_back("the MJCF has no motor for joints " + Listed(idle_));
  }

 private:
  void TakeServo(int i, SourceJoint* joint) const {
    if (!IsJointServo(m_, i)) return;
    const double gear = m_.actuator_gear[6 * i];
    double kv = -m_.actuator_biasprm[mjNBIAS * i + 2];
    if (kv == 0.0 && m_.nuser_actuator > 0) kv = m_.actuator_user[m_.nuser_actuator * i];
    const double stiffness = m_.actuator_gainprm[mjNGAIN * i] * gear * gear;
    joint->servo_stiffness_Nm_per_rad = stiffness;
    // Today's MuJoCo has a positive bias for a ratio of damping: of the joint at first, armature
    // and all that hangs on it included, not its own damping.
    const double inertia = m_.dof_M0[m_.jnt_dofadr[m_.actuator_trnid[2 * i]]];
    joint->servo_damping_Nms_per_rad =
        kv >= 0.0 ? kv * gear * gear : -kv * 2.0 * std::sqrt(stiffness * inertia);
  }

  double JointLimitOf(int id) const {
    if (m_.nuser_jnt < 2) return kUnbound;
    const double bound = RangeBound(m_.jnt_user + m_.nuser_jnt * id);
    return bound > 0.0 ? bound : kUnbound;
  }

  const mjModel& m_;
  MjcfBodies& bodies_;
  std::vector<std::string> idle_;
};

}  // namespace

void TakeMotors(const mjModel& model, MjcfBodies* bodies, Notes* notes) {
  MotorTaker(model, bodies).Take(notes);
}

}  // namespace sidestep::importer
