// SPDX-License-Identifier: BSD-3-Clause
#include "models/mjcf/leg_root.h"
#include "models/mjcf/mjcf.h"
#include "models/robot_description/fault_parts.h"

namespace sidestep {
namespace {

// A force/torque sensor feels all that is at and below the body of its site.
struct Sensor {
  std::string name;
  int body{0};
};

std::string NameOf(const mjModel& model, int body) {
  const char* name = mj_id2name(&model, mjOBJ_BODY, body);
  return "'" + std::string(name != nullptr ? name : "") + "'";
}

/// Of two that are summed: whether one feels what the other does.
std::string Overlap(const mjModel& model, const Sensor& one, const Sensor& other) {
  const std::string parent = NameOf(model, model.body_parentid[one.body]);
  if (one.body == other.body) {
    return "measures the same cut as '" + other.name + "', between " + NameOf(model, one.body) +
           " and its parent " + parent;
  }
  const bool is_below = IsAtOrBelow(model, one.body, other.body);
  if (!is_below && !IsAtOrBelow(model, other.body, one.body)) return "";
  const Sensor& above = is_below ? other : one;
  return "and '" + other.name +
         "' measure the same force: " + NameOf(model, is_below ? one.body : other.body) +
         " hangs on " + NameOf(model, above.body) + ", which '" + above.name + "' feels whole";
}

void AddOverlaps(const mjModel& model, const std::vector<std::string>& names,
                 const std::string& key, std::vector<RobotFault>* faults) {
  std::vector<Sensor> seen;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const int site = RequireId(model, mjOBJ_SITE, names[i]);
    const Sensor sensor{names[i], model.site_bodyid[site]};
    for (const Sensor& other : seen) {
      const std::string overlap = Overlap(model, sensor, other);
      if (overlap.empty()) continue;
      faults->push_back({key + "." + std::to_string(i), "= '" + sensor.name + "' " + overlap +
                                                            "; their sum would count it twice"});
    }
    seen.push_back(sensor);
  }
}

}  // namespace

void AddSensorFaults(const RobotAtHome& at_home, std::vector<RobotFault>* faults) {
  const RobotDescription& robot = at_home.robot;
  for (std::size_t i = 0; i < robot.feet.size(); ++i) {
    AddOverlaps(at_home.model, robot.feet[i].force_torque, FootKey(i, "force_torque"), faults);
  }
  AddOverlaps(at_home.model, robot.arm_force_torque, "arm_force_torque", faults);
}

}  // namespace sidestep
