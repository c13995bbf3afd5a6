// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/xml_tree.h"

#include <tinyxml.h>

#include <algorithm>
#include <cstdint>

#include "models/import/text.h"
#include "models/mjcf/mjcf_bounds.h"
#include "models/support/xml_bounds.h"
#include "models/urdf_to_mjcf/parse_xml.h"

namespace sidestep::importer {
namespace {

constexpr std::size_t kMaxFiles = 1000;  // of a document, each time that it is included

class TreeReader {
 public:
  TreeReader(std::filesystem::path main, const MeshFiles& files)
      : main_(std::move(main)), files_(files), problems_(main_.string()) {}

  XmlTree Read() {
    tree_.root = ReadFile(main_, main_.string(), 0);
    problems_.ThrowIfAny();
    return std::move(tree_);
  }

 private:
  /// @param name  As it is told; the last of open_ is the real file.
  XmlElement ReadFile(const std::filesystem::path& file, const std::string& name, int depth) {
    const std::string text = ReadXmlText(file);
    num_bytes_ += text.size();
    TiXmlDocument document;
    ParseXml(name, text, &document);
    if (document.RootElement() == nullptr) throw ConfigError(name + ": error: is no MJCF");
    tree_.files.push_back(name);
    open_.push_back(std::filesystem::weakly_canonical(file));
    XmlElement root;
    Take(*document.RootElement(), tree_.files.size() - 1, depth, &root);
    open_.pop_back();
    return root;
  }

  void Take(const TiXmlElement& from, std::size_t file, int depth, XmlElement* to) {
    to->tag = from.ValueStr();
    to->file = file;
    to->place = PlaceOf(from);
    if (depth > kMaxMjcfDepth || ++num_elements_ > kMaxXmlElements) {
      throw ConfigError(tree_.Place(*to) + ": error: there are too many elements, or too deep " +
                        "inside each other, with the files that are included");
    }
    for (const TiXmlAttribute* a = from.FirstAttribute(); a != nullptr; a = a->Next()) {
      to->attributes.emplace_back(a->Name(), a->ValueStr());
    }
    for (const TiXmlElement* e = from.FirstChildElement(); e; e = e->NextSiblingElement()) {
      if (e->ValueStr() == "include") {
        Include(*e, file, depth, to);
      } else {
        Take(*e, file, depth + 1, &to->children.emplace_back());
      }
    }
  }

  void Include(const TiXmlElement& element, std::size_t file, int depth, XmlElement* to) {
    const char* name = element.Attribute("file");
    const std::string place = AtPlace(tree_.files[file], PlaceOf(element));
    const std::string what = "<include file=\"" + std::string(name == nullptr ? "" : name) + "\"> ";
    std::string why;
    std::filesystem::path found = files_.FindFile(name == nullptr ? "" : name, &why);
    if (found.empty() && name != nullptr) {
      const std::filesystem::path beside = open_.back().parent_path() / name;
      std::string ignored;
      found = files_.FindFile(beside.string(), &ignored);
    }
    if (found.empty()) {
      problems_.AddAt(place, what + why);
    } else if (std::find(open_.begin(), open_.end(), found) != open_.end()) {
      problems_.AddAt(place, what + "includes itself");
    } else if (tree_.files.size() == kMaxFiles) {
      throw ConfigError(place + ": error: " + what + "is one file too many");
    } else if (num_bytes_ + std::filesystem::file_size(found) > kMaxXmlBytes) {
      throw ConfigError(place + ": error: " + what + "is too much: an MJCF may have " +
                        std::to_string(kMaxXmlBytes >> 20U) +
                        " MiB, with the files that it includes");
    } else {
      XmlElement root =
          ReadFile(found, (main_.parent_path() / name).lexically_normal().string(), depth + 1);
      std::move(root.children.begin(), root.children.end(), std::back_inserter(to->children));
    }
  }

  std::filesystem::path main_;
  const MeshFiles& files_;
  Problems problems_;
  XmlTree tree_;
  std::vector<std::filesystem::path> open_;
  int num_elements_{0};
  std::uintmax_t num_bytes_{0};
};

void Write(const XmlElement& element, std::string* text, std::vector<const XmlElement*>* lines) {
  *text += "<" + element.tag;
  for (const auto& [name, value] : element.attributes) {
    *text += " " + name + "=\"" + XmlEscaped(value) + "\"";
  }
  *text += element.children.empty() ? "/>\n" : ">\n";
  if (lines != nullptr) lines->push_back(&element);
  for (const XmlElement& child : element.children) Write(child, text, lines);
  if (element.children.empty()) return;
  *text += "</" + element.tag + ">\n";
  if (lines != nullptr) lines->push_back(&element);
}

}  // namespace

const std::string* XmlElement::Find(const std::string& name) const {
  for (const auto& [key, value] : attributes) {
    if (key == name) return &value;
  }
  return nullptr;
}

std::string XmlElement::Text(const std::string& name) const {
  const std::string* value = Find(name);
  return value == nullptr ? "" : *value;
}

void XmlElement::Set(const std::string& name, const std::string& value) {
  Erase(name);
  attributes.emplace_back(name, value);
}

void XmlElement::Erase(const std::string& name) {
  std::erase_if(attributes, [&](const auto& attribute) { return attribute.first == name; });
}

std::string XmlTree::Place(const XmlElement& element) const {
  return AtPlace(files[element.file], element.place);
}

XmlTree ReadXmlTree(const std::filesystem::path& file, const MeshFiles& files) {
  return TreeReader(file, files).Read();
}

std::string XmlText(const XmlElement& root, std::vector<const XmlElement*>* lines) {
  std::string text;
  Write(root, &text, lines);
  return text;
}

}  // namespace sidestep::importer
