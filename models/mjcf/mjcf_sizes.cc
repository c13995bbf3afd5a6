// SPDX-License-Identifier: BSD-3-Clause
#include "models/mjcf/mjcf_sizes.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>

namespace sidestep {
namespace {

/// The product of the numbers that an attribute holds may be `most`.
struct SizeBound {
  std::string_view element;
  std::string_view attribute;  ///< "*": any other of the element.
  double most;
};

constexpr std::array<SizeBound, 10> kBounds{{
    {"size", "nstack", 1e8},  // doubles
    {"size", "nuserdata", 1e6},
    {"size", "*", 5000},  // njmax among them, of which the stack holds five squares
    {"texture", "width", 8192},
    {"texture", "height", 8192},
    {"texture", "gridsize", 100},
    {"hfield", "nrow", 2000},
    {"hfield", "ncol", 2000},
    {"composite", "count", 500},  // bodies
    {"numeric", "size", 500},
}};

const SizeBound* BoundOf(std::string_view element, std::string_view attribute) {
  const auto found = std::find_if(kBounds.begin(), kBounds.end(), [&](const SizeBound& bound) {
    return bound.element == element && (bound.attribute == attribute || bound.attribute == "*");
  });
  return found == kBounds.end() ? nullptr : &*found;
}

/// Of the magnitudes; 0 of what is no list of numbers, which MuJoCo refuses itself.
double ProductOf(const std::string& value) {
  std::istringstream words(value);
  double product = 1.0;
  for (std::string word; words >> word;) product *= std::abs(std::strtod(word.c_str(), nullptr));
  return product;
}

}  // namespace

void MjcfSizes::Check(const XmlTags& tags, const XmlTag& tag) {
  const bool is_joint = tag.name == "joint" || tag.name == "freejoint";
  if (is_joint && ++num_joints_ > kMaxMjcfJoints) {
    tags.Fail(tag.begin, "is one joint too many: an MJCF may have " +
                             std::to_string(kMaxMjcfJoints) + ", with the files that it includes");
  }
  for (const XmlAttribute& attribute : tag.attributes) {
    const SizeBound* bound = BoundOf(tag.name, attribute.name);
    if (bound == nullptr) continue;
    const std::optional<std::string> value = XmlDecoded(attribute.value);
    if (value && ProductOf(*value) <= bound->most) continue;
    std::ostringstream what;
    what << "<" << tag.name << "> has " << attribute.name << " = '"
         << value.value_or(std::string(attribute.value)) << "', more than a robot's "
         << bound->most;
    tags.Fail(tag.begin, what.str());
  }
}

}  // namespace sidestep
