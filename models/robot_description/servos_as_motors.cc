// SPDX-License-Identifier: BSD-3-Clause
#include "models/robot_description/servos_as_motors.h"

#include <tinyxml.h>

#include <array>
#include <cmath>
#include <vector>

#include "models/mjcf/joint_servo.h"
#include "models/mjcf/mjcf.h"
#include "models/support/xml_bounds.h"
#include "models/support/xml_tags.h"
#include "models/urdf_to_mjcf/mjcf_text.h"

namespace sidestep {
namespace {

bool MayHoldServos(const std::string& file, const std::string& text) {
  XmlTags tags(file, text);
  while (const auto tag = tags.Next()) {
    if (tag->name == "position" || tag->name == "general" || tag->name == "intvelocity") {
      return true;
    }
  }
  return false;
}

/// Actuators, in their order.
std::vector<TiXmlElement*> ActuatorsOf(TiXmlElement& root) {
  std::vector<TiXmlElement*> actuators;
  for (TiXmlElement* section = root.FirstChildElement("actuator"); section != nullptr;
       section = section->NextSiblingElement("actuator")) {
    for (TiXmlElement* e = section->FirstChildElement(); e; e = e->NextSiblingElement()) {
      actuators.push_back(e);
    }
  }
  return actuators;
}

/// Of no class but the outermost, of which nothing that matters is left to be taken.
void BecomeMotor(double limit_Nm, TiXmlElement* servo) {
  TiXmlElement motor("motor");
  for (const char* key : {"name", "joint", "jointinparent"}) {
    if (servo->Attribute(key) != nullptr) motor.SetAttribute(key, servo->Attribute(key));
  }
  const bool is_limited = std::isfinite(limit_Nm);
  motor.SetAttribute("gear", "1");
  motor.SetAttribute("forcelimited", "false");
  motor.SetAttribute("ctrllimited", is_limited ? "true" : "false");
  if (is_limited) {
    motor.SetAttribute("ctrlrange", (Number(-limit_Nm) + " " + Number(limit_Nm)).c_str());
  }
  *servo = motor;
}

}  // namespace

std::string WithServosAsMotors(const std::string& text, const std::filesystem::path& file) {
  if (!MayHoldServos(file.string(), text)) return text;
  std::array<char, 1000> ignored{};
  const MjModelPtr model(
      mj_loadXML(file.c_str(), nullptr, ignored.data(), static_cast<int>(ignored.size())));
  TiXmlDocument document;
  document.Parse(WithoutStrayBytes(text).c_str(), nullptr, TIXML_ENCODING_UTF8);
  if (!model || document.Error() || document.RootElement() == nullptr) return text;
  const std::vector<TiXmlElement*> actuators = ActuatorsOf(*document.RootElement());
  if (static_cast<int>(actuators.size()) != model->nu) return text;
  bool has_changed = false;
  for (int i = 0; i < model->nu; ++i) {
    if (!IsJointServo(*model, i)) continue;
    BecomeMotor(JointEffortLimit_Nm(*model, i), actuators[static_cast<std::size_t>(i)]);
    has_changed = true;
  }
  if (!has_changed) return text;
  TiXmlPrinter printer;
  document.Accept(&printer);
  return printer.Str();
}

}  // namespace sidestep
