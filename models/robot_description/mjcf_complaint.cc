// SPDX-License-Identifier: BSD-3-Clause
#include "models/robot_description/mjcf_complaint.h"

#include <algorithm>
#include <string_view>

#include "models/mjcf/mjcf_bounds.h"
#include "models/mjcf/mjcf_message.h"
#include "models/support/config_error.h"
#include "models/support/text_place.h"

namespace sidestep {
namespace {

/// What stands in quotes behind `words`; empty if they are not there.
std::string QuotedAfter(const std::string& words, const std::string& text) {
  const std::size_t found = text.find(words + " '");
  if (found == std::string::npos) return "";
  const std::size_t begin = found + words.size() + 2;
  return text.substr(begin, text.find('\'', begin) - begin);
}

/// The element and the attribute that MuJoCo complains of; empty where it names none.
struct Complaint {
  explicit Complaint(const std::string& text)
      : message(ReadMjcfMessage(text)),
        element(QuotedAfter("Element", message.what)),
        attribute(QuotedAfter("unrecognized attribute:", message.what)),
        is_new_element(message.what.find("unrecognized element") != std::string::npos) {}

  bool IsOf(const XmlTags& tags, const XmlTag& tag) const {
    return tag.name == element && (attribute.empty() || tag.Find(attribute) != nullptr) &&
           (message.line < 1 || PlaceIn(tags.text(), tag.begin).line == message.line);
  }

  /// Of words that are newer than the MuJoCo at hand, what is to be done.
  std::string Words() const {
    const std::string unknown = "MuJoCo 2.2 doesn't know; delete it";
    if (!attribute.empty()) return "<" + element + "> has " + attribute + ", which " + unknown;
    if (is_new_element) return "<" + element + "> is an element that " + unknown;
    return message.what;
  }

  MjcfMessage message;
  std::string element;
  std::string attribute;
  bool is_new_element{false};
};

}  // namespace

void FailToCompile(const std::filesystem::path& mjcf, const std::string& message) {
  const Complaint complaint(message);
  const int line = complaint.message.line;
  VisitMjcf(mjcf, [&](const XmlTags& tags, const XmlTag& tag) {
    const bool is_main = tags.file() == mjcf.string();  // which has lines, and no other has
    if (is_main != (line > 0) || !complaint.IsOf(tags, tag)) return;
    tags.Fail(tag.begin, complaint.Words());
  });
  if (line < 1) throw ConfigError(mjcf.string() + ": error: " + complaint.Words());
  throw ConfigError(mjcf.string(), line, std::max(complaint.message.column, 1), complaint.Words());
}

void RefuseAssetFiles(const std::filesystem::path& mjcf) {
  VisitMjcf(mjcf, [](const XmlTags& tags, const XmlTag& tag) {
    if (IsInclude(tag) || tag.Find("file") == nullptr) return;
    tags.Fail(tag.begin, "<" + std::string(tag.name) + "> reads the file '" +
                             std::string(*tag.Find("file")) +
                             "', but a robot's MJCF is compiled from its text alone; `sidestep "
                             "robots import` takes it with its meshes");
  });
}

}  // namespace sidestep
