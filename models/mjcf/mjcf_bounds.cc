// SPDX-License-Identifier: BSD-3-Clause
#include "models/mjcf/mjcf_bounds.h"

#include <optional>
#include <set>
#include <string_view>
#include <system_error>
#include <vector>

#include "models/mjcf/mjcf_sizes.h"
#include "models/support/xml_bounds.h"
#include "models/support/xml_tags.h"

namespace sidestep {
namespace {

constexpr char kWithIncluded[] = ", with the files that it includes";

/// Reads an MJCF and what it includes, and adds up.
class BoundsChecker {
 public:
  explicit BoundsChecker(const std::filesystem::path& mjcf) : mjcf_(mjcf) {}

  void Check() {
    std::error_code ignored;
    if (std::filesystem::is_regular_file(mjcf_, ignored)) CheckFile({mjcf_, ReadXmlText(mjcf_), 0});
    while (!open_.empty()) {
      const File file = std::move(open_.back());
      open_.pop_back();
      CheckFile(file);
    }
  }

 private:
  struct File {
    std::filesystem::path path;
    std::string text;
    int depth{0};  ///< Of what includes it.
  };

  void CheckFile(const File& file) {
    const std::string name = file.path.string();
    XmlTags tags(name, file.text);
    if (file.depth == 0) num_bytes_ = file.text.size();
    while (const auto tag = tags.Next()) {
      if (++num_elements_ > kMaxMjcfElements) {
        tags.Fail(tag->begin, "is one element too many: an MJCF may have " +
                                  std::to_string(kMaxMjcfElements) + kWithIncluded);
      }
      if (file.depth + tag->depth > kMaxMjcfDepth) {
        tags.Fail(tag->begin, "is nested deeper than " + std::to_string(kMaxMjcfDepth) +
                                  ", with the files that include it");
      }
      sizes_.Check(tags, *tag);
      if (IsInclude(*tag)) Include(tags, *tag, file.depth);
    }
  }

  /// MuJoCo refuses a name that is there twice; another name of the same file is another file.
  void Include(const XmlTags& tags, const XmlTag& tag, int depth) {
    const std::string_view* value = tag.Find("file");
    if (value == nullptr) return;
    const std::optional<std::string> name = XmlDecoded(*value);
    if (!name) tags.Fail(tag.begin, "<include> has a file with a reference to no character");
    if (!names_.insert(*name).second) return;
    const std::filesystem::path path = IncludedFile(mjcf_, *name);
    std::error_code ignored;
    if (!std::filesystem::exists(path, ignored)) return;
    if (!std::filesystem::is_regular_file(path, ignored)) {
      tags.Fail(tag.begin, "<include> of '" + *name + "', which is no file");
    }
    File file{path, ReadXmlText(path), depth + tag.depth};
    num_bytes_ += file.text.size();
    if (num_bytes_ > kMaxXmlBytes) {
      tags.Fail(tag.begin, "<include> of '" + *name + "' is too much: an MJCF may have " +
                               std::to_string(kMaxXmlBytes >> 20U) + " MiB" + kWithIncluded);
    }
    open_.push_back(std::move(file));
  }

  const std::filesystem::path& mjcf_;
  std::vector<File> open_;
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

void CheckMjcfBounds(const std::filesystem::path& mjcf) { BoundsChecker(mjcf).Check(); }

}  // namespace sidestep
