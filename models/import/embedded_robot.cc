// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/embedded_robot.h"

#include <tinyxml.h>

#include <algorithm>

#include "models/import/text.h"
#include "models/mjcf/mjcf.h"
#include "models/support/hash_text.h"
#include "models/support/plain_word.h"
#include "models/support/xml_tags.h"

namespace sidestep::importer {
namespace {

constexpr char kBegin[] = "<!-- For sidestep robots import: the robot's own files. -->\n<custom>\n";
constexpr char kEnd[] = "</custom>\n";
constexpr char kFile[] = "sidestep file ";  // of the texts' names
constexpr char kChecksum[] = "sidestep checksum";

/// Against an editor's hand, not against malice.
std::string ChecksumOf(const std::string& mjcf, const RobotFiles& files) {
  std::string all = mjcf;
  for (const auto& [name, text] : files) all += name + '\n' + text;
  const std::string digits = HashText(all);
  return digits.substr(std::min(digits.find_first_not_of('0'), digits.size() - 1));
}

/// As an attribute's value that keeps its line ends.
std::string Attribute(const std::string& text) {
  std::string value;
  for (const char c : XmlEscaped(text)) {
    value += c == '\n' ? "&#10;" : c == '\t' ? "&#9;" : c == '\r' ? "&#13;" : std::string(1, c);
  }
  return value;
}

std::string TextElement(const std::string& name, const std::string& data) {
  return "<text name=\"" + Attribute(name) + "\" data=\"" + Attribute(data) + "\"/>\n";
}

/// Whether the MJCF names other files: what it includes, meshes, heights, textures.
bool NamesFiles(const std::string& file, const std::string& mjcf) {
  XmlTags tags(file, mjcf);
  while (const auto tag = tags.Next()) {
    const bool has_file =
        std::any_of(tag->attributes.begin(), tag->attributes.end(),
                    [](const XmlAttribute& known) { return known.name.starts_with("file"); });
    if (has_file) return true;
  }
  return false;
}

bool OpensOthers(const RobotDescription& robot, const std::string& yaml, const std::string& model) {
  if (yaml.find("\nmeshes:") != std::string::npos) return true;
  return robot.model->language == ModelLanguage::kMjcf &&
         NamesFiles(robot.model->file.string(), model);
}

}  // namespace

std::string WithRobotFiles(const std::string& mjcf, const RobotDescription& robot) {
  const std::size_t end = mjcf.rfind("</mujoco>");
  const bool is_beside = robot.model && robot.model->file.parent_path() == robot.file.parent_path();
  if (!is_beside || end == std::string::npos) return mjcf;
  const std::string yaml = ReadTextFile(robot.file), model = ReadTextFile(robot.model->file);
  if (OpensOthers(robot, yaml, model)) return mjcf;
  const RobotFiles files{{robot.file.filename().string(), yaml},
                         {robot.model->file.filename().string(), model}};
  std::string block = kBegin;
  for (const auto& [name, text] : files) block += TextElement(kFile + name, text);
  block += TextElement(kChecksum, ChecksumOf(mjcf, files)) + kEnd;
  return mjcf.substr(0, end) + block + mjcf.substr(end);
}

std::optional<RobotFiles> RobotFilesIn(const std::string& mjcf) {
  const std::size_t begin = mjcf.rfind(kBegin);
  const std::size_t end = begin == std::string::npos ? begin : mjcf.find(kEnd, begin);
  if (end == std::string::npos) return std::nullopt;
  const std::string block = mjcf.substr(begin, end + sizeof(kEnd) - 1 - begin);
  TiXmlDocument document;
  document.Parse(block.c_str(), nullptr, TIXML_ENCODING_UTF8);
  if (document.Error() || document.RootElement() == nullptr) return std::nullopt;
  RobotFiles files;
  std::string checksum;
  for (const TiXmlElement* e = document.RootElement()->FirstChildElement("text"); e != nullptr;
       e = e->NextSiblingElement("text")) {
    const std::string name = e->Attribute("name") == nullptr ? "" : e->Attribute("name");
    const std::string data = e->Attribute("data") == nullptr ? "" : e->Attribute("data");
    if (name == kChecksum) checksum = data;
    if (name.rfind(kFile, 0) == 0) files.emplace_back(name.substr(sizeof(kFile) - 1), data);
  }
  for (const auto& [name, text] : files) {
    if (!IsPlainWord(name)) return std::nullopt;  // it is about to be a file
  }
  const std::string rest = mjcf.substr(0, begin) + mjcf.substr(begin + block.size());
  if (files.empty() || checksum != ChecksumOf(rest, files)) return std::nullopt;
  return files;
}

}  // namespace sidestep::importer
