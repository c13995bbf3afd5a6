// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/mjcf_newer.h"

#include <cmath>
#include <cstdlib>
#include <set>
#include <sstream>
#include <vector>

#include "models/urdf_to_mjcf/mjcf_text.h"

namespace sidestep::importer {
namespace {

constexpr double kMaxNumber = 1e12;

/// Attributes that change nothing of what is read here, whatever MuJoCo knows of them.
const std::set<std::string>& Needless() {
  static const std::set<std::string> kWords{"user",
                                            "actuatorfrclimited",
                                            "actuatorgravcomp",
                                            "align",
                                            "sleep",
                                            "maxhullvert",
                                            "content_type",
                                            "inheritrange",
                                            "actrange",
                                            "actlimited",
                                            "actearly",
                                            "actdim",
                                            "lengthrange",
                                            "texture",
                                            "texrepeat",
                                            "texuniform",
                                            "emission",
                                            "specular",
                                            "shininess",
                                            "reflectance",
                                            "metallic",
                                            "roughness",
                                            "texcoord",
                                            "normal",
                                            "smoothnormal",
                                            "material_texture",
                                            "delay",
                                            "nsample",
                                            "interp"};
  return kWords;
}

/// Attributes that do change something, which our robot will lack: told one by one.
const std::map<std::string, std::string>& LeftOut() {
  static const std::map<std::string, std::string> kWords{
      {"gravcomp", "gravity acts on it here"},
      {"timeconst", "its servo answers at once here"},
      {"inertia", "its mass is that of its volume here"}};
  return kWords;
}

bool IsServo(const XmlElement& element) {
  return element.tag == "position" || element.tag == "intvelocity";
}

std::string NameOf(const XmlElement& element) {
  std::string text = "<" + element.tag + ">";
  for (const char* key : {"name", "class", "joint", "mesh"}) {
    if (element.Find(key) != nullptr) return text + " '" + element.Text(key) + "'";
  }
  return text;
}

bool IsText(const std::string& attribute) {
  static const std::set<std::string> kTexts{"name",  "class", "childclass",    "file",
                                            "mesh",  "joint", "jointinparent", "material",
                                            "geom1", "geom2"};
  return kTexts.count(attribute) > 0;
}

}  // namespace

void NewerWords::Mend(const std::string& parent, XmlElement* element) {
  CheckNumbers(*element);
  std::string user;
  if (element->tag == "joint" && element->Text("actuatorfrclimited") != "false") {
    user = element->Text("actuatorfrcrange");
  }
  const bool is_servo = IsServo(*element);
  const bool is_kv_newer = is_servo && !schema_.HasAttribute(parent, element->tag, "kv");
  if (is_servo) user = DampingOf(*element, is_kv_newer);
  std::vector<std::pair<std::string, std::string>> kept;
  for (const auto& [name, value] : element->attributes) {
    const auto left_out = LeftOut().find(name);
    const bool is_known = schema_.HasAttribute(parent, element->tag, name);
    if (name == "actuatorfrcrange" || (name == "kv" && is_kv_newer)) continue;
    if (name == "dampratio" && is_servo) continue;
    if (Needless().count(name) > 0) {
      if (!is_known) ++taken_out_[name];
    } else if (is_known) {
      kept.emplace_back(name, value);
    } else if (left_out != LeftOut().end() && value == "0") {
      ++taken_out_[name];
    } else if (left_out != LeftOut().end()) {
      left_out_.push_back(tree_.Place(*element) + ": left out " + name + "=\"" + value + "\" of " +
                          NameOf(*element) + ": " + left_out->second);
    } else {
      problems_.AddAt(tree_.Place(*element), NameOf(*element) + " has " + name + "=\"" +
                                                 value.substr(0, 40) +
                                                 "\", which MuJoCo 2.2 doesn't know; delete it");
    }
  }
  element->attributes = std::move(kept);
  if (!user.empty()) element->Set("user", user);
}

std::string NewerWords::DampingOf(const XmlElement& servo, bool is_kv_newer) {
  const std::string* kv = is_kv_newer ? servo.Find("kv") : nullptr;
  const std::string* ratio = servo.Find("dampratio");
  if (ratio == nullptr) return kv == nullptr ? "" : *kv;
  const double number = std::strtod(ratio->c_str(), nullptr);
  if (servo.Find("kv") != nullptr) {
    problems_.AddAt(tree_.Place(servo), NameOf(servo) + " has kv and dampratio; delete one");
  } else if (number < 0.0) {
    problems_.AddAt(tree_.Place(servo), NameOf(servo) + " has dampratio=\"" + *ratio +
                                            "\", which must not be negative");
  }
  return number > 0.0 ? Number(-number) : "0";
}

void NewerWords::RefuseElement(const XmlElement& element) {
  static const std::map<std::string, std::string> kMends{
      {"replicate", "write out the bodies that it makes"},
      {"attach", "put the attached model's bodies in its place"},
      {"composite", "a robot's bodies are rigid; delete it"},
      {"flexcomp", "a robot's bodies are rigid; delete it"},
      {"plugin", "no plugin is loaded; delete it"}};
  const auto mend = kMends.find(element.tag);
  problems_.AddAt(
      tree_.Place(element),
      NameOf(element) + " can't be taken: " +
          (mend == kMends.end() ? "MuJoCo 2.2 doesn't know it; delete it" : mend->second));
}

void NewerWords::RefuseChildren(const XmlElement& element) {
  for (const XmlElement& child : element.children) RefuseElement(child);
}

void NewerWords::Tell(Notes* notes) const {
  std::string text;
  for (const auto& [name, count] : taken_out_) {
    text += (text.empty() ? "" : ", ") + name + " (" + std::to_string(count) + ")";
  }
  if (!text.empty()) {
    notes->push_back("took out what is newer than MuJoCo 2.2 and changes nothing here: " + text);
  }
  notes->insert(notes->end(), left_out_.begin(), left_out_.end());
}

void NewerWords::CheckNumbers(const XmlElement& element) {
  for (const auto& [name, value] : element.attributes) {
    if (IsText(name)) continue;
    std::istringstream words(value);
    for (std::string word; words >> word;) {
      char* end = nullptr;
      const double number = std::strtod(word.c_str(), &end);
      if (end != word.c_str() + word.size() || std::abs(number) <= kMaxNumber) continue;
      problems_.AddAt(tree_.Place(element), NameOf(element) + " has " + name + " with '" +
                                                word.substr(0, 40) +
                                                "', which is no number to use");
      break;
    }
  }
}

}  // namespace sidestep::importer
