// SPDX-License-Identifier: BSD-3-Clause
#include "models/robot_description/robot_model.h"

#include "models/support/xml_bounds.h"

namespace sidestep {

const char* LanguageName(ModelLanguage language) {
  return language == ModelLanguage::kMjcf ? "MJCF" : "URDF";
}

RobotModel ReadMjcfModel(const std::filesystem::path& file) {
  const std::string text = ReadXmlText(file);
  return {ModelLanguage::kMjcf, file, text, text, ""};
}

}  // namespace sidestep
