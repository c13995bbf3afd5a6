// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/mjcf_motors.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "models/import/text.h"

namespace sidestep::importer {
namespace {

constexpr double kUnbound = std::numeric_limits<double>::infinity();
constexpr double kSame = 1e-9;  // of two gains, in the one's size

/// What holds both ways; of a range that begins at zero, its other end.
double Bound(const mjtNum* range) {
  const double nearer = std::min(-range[0], range[1]);
  return nearer > 0.0 ? nearer : std::max(std::abs(range[0]), std::abs(range[1]));
}

class MotorTaker {
 public:
  MotorTaker(const mjModel& model, MjcfBodies* bodies) : m_(model), bodies_(*bodies) {}

  void Take(Notes* notes) {
    std::vector<double> limits(bodies_.robot.joints.size(), 0.0);
    for (int i = 0; i < m_.nu; ++i) {
      const int index = bodies_.joint[static_cast<std::size_t>(m_.actuator_trnid[2 * i])];
      if (index < 0) continue;
      SourceJoint& joint = bodies_.robot.joints[static_cast<std::size_t>(index)];
      limits[static_cast<std::size_t>(index)] += LimitOf(i);
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
  bool IsServo(int i) const {
    const double gain = m_.actuator_gainprm[mjNGAIN * i];
    const double bias = m_.actuator_biasprm[mjNBIAS * i + 1];
    return m_.actuator_gaintype[i] == mjGAIN_FIXED && m_.actuator_biastype[i] == mjBIAS_AFFINE &&
           gain > 0.0 && std::abs(gain + bias) <= kSame * gain &&
           m_.actuator_biasprm[mjNBIAS * i] == 0.0;
  }

  double LimitOf(int i) const {
    double limit = kUnbound;
    const bool is_motor = m_.actuator_biastype[i] == mjBIAS_NONE;
    if (is_motor && m_.actuator_ctrllimited[i] != 0) {
      limit = std::abs(m_.actuator_gainprm[mjNGAIN * i]) * Bound(m_.actuator_ctrlrange + 2 * i);
    }
    if (m_.actuator_forcelimited[i] != 0) {
      limit = std::min(limit, Bound(m_.actuator_forcerange + 2 * i));
    }
    return limit * std::abs(m_.actuator_gear[6 * i]);
  }

  void TakeServo(int i, SourceJoint* joint) const {
    if (!IsServo(i)) return;
    const double gear = m_.actuator_gear[6 * i];
    double kv = -m_.actuator_biasprm[mjNBIAS * i + 2];
    if (kv == 0.0 && m_.nuser_actuator > 0) kv = m_.actuator_user[m_.nuser_actuator * i];
    joint->servo_stiffness_Nm_per_rad = m_.actuator_gainprm[mjNGAIN * i] * gear * gear;
    joint->servo_damping_Nms_per_rad = std::max(0.0, kv) * gear * gear;
  }

  double JointLimitOf(int id) const {
    if (m_.nuser_jnt < 2) return kUnbound;
    const double bound = Bound(m_.jnt_user + m_.nuser_jnt * id);
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
