// SPDX-License-Identifier: BSD-3-Clause
#include "models/robot_description/robot_model.h"

#include "models/mjcf/mjcf_bounds.h"
#include "models/robot_description/mjcf_includes.h"
#include "models/robot_description/servos_as_motors.h"
#include "models/support/xml_bounds.h"

namespace sidestep {

const char* LanguageName(ModelLanguage language) {
  return language == ModelLanguage::kMjcf ? "MJCF" : "URDF";
}

RobotModel ReadMjcfModel(const std::filesystem::path& file) {
  CheckMjcfBounds(file);
  const std::string text = WithServosAsMotors(WithIncluded(ReadXmlText(file), file), file);
  return {ModelLanguage::kMjcf, file, text, text, ""};
}

}  // namespace sidestep
