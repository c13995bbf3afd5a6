// SPDX-License-Identifier: BSD-3-Clause
#include "models/mjcf/mjcf_bounds.h"

#include <optional>
#include <set>
#include <string_view>
#include <system_error>

#include "models/mjcf/mjcf_sizes.h"
#include "models/support/xml_bounds.h"

namespace sidestep {
namespace {

constexpr char kWithIncluded[] = ", with the files that it includes";

/// Reads an MJCF and what it includes, and adds up.
class BoundsChecker {
 public:
  BoundsChecker(const std::filesystem::path& mjcf, const TagVisitor& visit)
      : mjcf_(mjcf), visit_(visit) {}

  /// @param depth  Of what includes the file.
  void CheckFile(const std::string& file, const std::string& text, int depth) {
    num_bytes_ += text.size();
    XmlTags tags(file, text);
    while (const auto tag = tags.Next()) {
      if (++num_elements_ > kMaxMjcfElements) {
        tags.Fail(tag->begin, "is one element too many: an MJCF may have " +
                                  std::to_string(kMaxMjcfElements) + kWithIncluded);
      }
      if (depth + tag->depth > kMaxMjcfDepth) {
        tags.Fail(tag->begin, "is nested deeper than " + std::to_string(kMaxMjcfDepth) +
                                  ", with the files that include it");
      }
      sizes_.Check(tags, *tag);
      visit_(tags, *tag);
      if (IsInclude(*tag)) Include(tags, *tag, depth + tag->depth);
    }
  }

 private:
  /// MuJoCo refuses a name that is there twice; another name of the same file is another file.
  void Include(const XmlTags& tags, const XmlTag& tag, int depth) {
    const std::string_view* value = tag.Find("file");
    if (value == nullptr) return;
    const std::optional<std::string> name = XmlDecoded(*value);
    if (!name) tags.Fail(tag.begin, "<include> has a file with a reference to no character");
    if (!names_.insert(*name).second) return;
    const std::filesystem::path path = IncludedFile(mjcf_, *name);
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(path, ignored)) {
      tags.Fail(tag.begin, "<include> of '" + *name + "', which is no file in the folder of " +
                               mjcf_.filename().string());
    }
    const std::string text = ReadXmlText(path);
    if (num_bytes_ + text.size() > kMaxXmlBytes) {
      tags.Fail(tag.begin, "<include> of '" + *name + "' is too much: an MJCF may have " +
                               std::to_string(kMaxXmlBytes >> 20U) + " MiB" + kWithIncluded);
    }
    CheckFile(path.string(), text, depth);
  }

  const std::filesystem::path& mjcf_;
  const TagVisitor& visit_;
  std::set<std::string> names_;  ///< Of includes, as they are written.
  MjcfSizes sizes_;
  std::size_t num_bytes_{0};
  std::ptrdiff_t num_elements_{0};
};

}  // namespace

std::filesystem::path IncludedFile(const std::filesystem::path& mjcf, const std::string& name) {
  const std::string folder = mjcf.parent_path().string();
  return folder.empty() ? name : folder + "/" + name;
}

void VisitMjcf(const std::filesystem::path& mjcf, const TagVisitor& visit) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(mjcf, ignored)) return;
  BoundsChecker(mjcf, visit).CheckFile(mjcf.string(), ReadXmlText(mjcf), 0);
}

void CheckMjcfBounds(const std::filesystem::path& mjcf) {
  VisitMjcf(mjcf, [](const XmlTags& /*tags*/, const XmlTag& /*tag*/) {});
}

}  // namespace sidestep
