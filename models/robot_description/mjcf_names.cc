// SPDX-License-Identifier: BSD-3-Clause
#include "models/robot_description/mjcf_names.h"

#include <array>
#include <optional>
#include <utility>

#include "models/mjcf/base_joints.h"
#include "models/mjcf/mjcf.h"
#include "models/mjcf/mjcf_bounds.h"
#include "models/robot_description/mjcf_complaint.h"
#include "models/support/config_node.h"
#include "models/support/file_notes.h"
#include "models/support/plain_word.h"

namespace sidestep {
namespace {

std::vector<std::string> NamesOfType(const mjModel& model, int type, int count) {
  std::vector<std::string> names;
  for (int id = 0; id < count; ++id) {
    const char* name = mj_id2name(&model, type, id);
    if (name != nullptr) names.emplace_back(name);
  }
  return names;
}

// What <motor> is short for: control is force.
bool IsMotor(const mjModel& model, int actuator) {
  return model.actuator_dyntype[actuator] == mjDYN_NONE &&
         model.actuator_gaintype[actuator] == mjGAIN_FIXED &&
         model.actuator_gainprm[mjNGAIN * actuator] == 1.0 &&
         model.actuator_biastype[actuator] == mjBIAS_NONE;
}

// Why a motor's control is not the joint's torque between -limit and limit.
std::optional<UnfitMotor> UnfitnessOf(const mjModel& model, int actuator) {
  if (model.actuator_trntype[actuator] != mjTRN_JOINT) {
    const char* name = mj_id2name(&model, mjOBJ_ACTUATOR, actuator);
    return UnfitMotor{name != nullptr ? name : "an unnamed actuator", "acts on no joint"};
  }
  const char* joint = mj_id2name(&model, mjOBJ_JOINT, model.actuator_trnid[2 * actuator]);
  const std::string name = joint != nullptr ? joint : "an unnamed joint";
  const mjtNum gear = model.actuator_gear[6 * actuator];
  if (!IsMotor(model, actuator)) return UnfitMotor{name, "is no <motor>"};
  if (gear != 1.0) return UnfitMotor{name, "has the gear " + NumberText(gear)};
  if (model.actuator_ctrllimited[actuator] == 0) return UnfitMotor{name, "has no ctrlrange", true};
  const mjtNum* range = model.actuator_ctrlrange + 2 * actuator;
  const std::string range_text = NumberText(range[0]) + " " + NumberText(range[1]);
  if (range[1] <= 0.0 || range[0] != -range[1]) {
    return UnfitMotor{name, "has the ctrlrange " + range_text, true};
  }
  const mjtNum* force = model.actuator_forcerange + 2 * actuator;
  if (model.actuator_forcelimited[actuator] != 0 && (force[0] > range[0] || force[1] < range[1])) {
    return UnfitMotor{name, "has a forcerange narrower than its ctrlrange " + range_text, true};
  }
  return {};
}

// Names become columns of tables and words of messages: those of parts that a robot.yaml may call.
void RequirePlainNames(const std::filesystem::path& mjcf, const mjModel& model) {
  const std::array<std::pair<mjtObj, int>, 5> kinds{{{mjOBJ_BODY, model.nbody},
                                                     {mjOBJ_JOINT, model.njnt},
                                                     {mjOBJ_SITE, model.nsite},
                                                     {mjOBJ_ACTUATOR, model.nu},
                                                     {mjOBJ_SENSOR, model.nsensor}}};
  FileNotes notes(mjcf.string());
  for (const auto& [type, count] : kinds) {
    for (const std::string& name : NamesOfType(model, type, count)) {
      if (IsPlainWord(name)) continue;
      notes.Problem({}, std::string(mju_type2Str(type)) + " '" + name.substr(0, kMaxWordLength) +
                            "': a name must be " + std::string(kPlainWordRule));
    }
  }
  notes.ThrowProblems();
}

}  // namespace

MjcfNames ReadMjcfNames(const std::filesystem::path& mjcf) {
  CheckMjcfBounds(mjcf);
  std::array<char, 1000> error{};
  const MjModelPtr model(
      mj_loadXML(mjcf.c_str(), nullptr, error.data(), static_cast<int>(error.size())));
  if (!model) FailToCompile(mjcf, error.data());
  RequirePlainNames(mjcf, *model);
  return NamesOf(*model);
}

MjcfNames NamesOf(const mjModel& model) {
  MjcfNames names;
  names.bodies = NamesOfType(model, mjOBJ_BODY, model.nbody);
  std::erase(names.bodies, "world");
  names.sites = NamesOfType(model, mjOBJ_SITE, model.nsite);
  names.sensors = NamesOfType(model, mjOBJ_SENSOR, model.nsensor);
  for (int id = 0; id < model.njnt; ++id) {
    const int type = model.jnt_type[id];
    const int body = model.jnt_bodyid[id];
    const bool is_of_base = BaseFreedomOf(model, body).has_value();
    const char* name =
        is_of_base ? mj_id2name(&model, mjOBJ_BODY, body) : mj_id2name(&model, mjOBJ_JOINT, id);
    if (name == nullptr) continue;
    if (is_of_base) {
      if (id == model.body_jntadr[body]) names.floating_bodies.emplace_back(name);
    } else if (type == mjJNT_HINGE || type == mjJNT_SLIDE) {
      names.joints.emplace_back(name);
    }
  }
  for (int id = 0; id < model.nu; ++id) {
    if (const auto unfit = UnfitnessOf(model, id)) names.unfit_motors.push_back(*unfit);
    if (model.actuator_trntype[id] != mjTRN_JOINT) continue;
    const char* joint = mj_id2name(&model, mjOBJ_JOINT, model.actuator_trnid[2 * id]);
    if (joint != nullptr) names.motor_joints.emplace_back(joint);
  }
  for (int body = 1; body < model.nbody; ++body) {
    const char* name = mj_id2name(&model, mjOBJ_BODY, body);
    if (name == nullptr || model.body_parentid[body] != 0 || model.body_jntnum[body] == 0) continue;
    std::string fault = BaseFault(model, body);
    if (!fault.empty()) names.base_faults.emplace(name, std::move(fault));
  }
  return names;
}

}  // namespace sidestep
