// SPDX-License-Identifier: BSD-3-Clause
#include "models/urdf_to_mjcf/urdf_values.h"

#include <cmath>
#include <sstream>
#include <string_view>

#include "models/support/parse_number.h"

namespace sidestep {
namespace {

std::string Tag(const TiXmlElement& element) { return "<" + element.ValueStr() + ">"; }

/// The fault of attributes that each must be a number greater than 0 (`count` 1) or several.
std::string FaultOfSize(TiXmlElement* shape, const char* attribute, std::size_t count) {
  if (shape->Attribute(attribute) == nullptr) {
    return "has a " + Tag(*shape) + " without " + attribute;
  }
  if (std::string fault = FaultOfNumbers(shape, attribute, count, kMaxUrdfLength_m); !fault.empty())
    return fault;
  std::istringstream numbers(TextOf(*shape, attribute));
  for (double number = 0.0; numbers >> number;) {
    if (number <= 0.0) {
      return "has a " + Tag(*shape) + " whose " + attribute + " = '" + TextOf(*shape, attribute) +
             "' is not greater than 0";
    }
  }
  return "";
}

/// URDFs of some simulators have capsules, whose length is that between the caps' centres. A
/// cylinder longer than wide will be a capsule of its own length: see urdf_to_mjcf.h.
void MakeCylinder(TiXmlElement* capsule) {
  const double length = FiniteNumber(TextOf(*capsule, "length")).value_or(0.0);
  const double radius = FiniteNumber(TextOf(*capsule, "radius")).value_or(0.0);
  capsule->SetValue("cylinder");
  std::ostringstream whole;
  whole.precision(17);
  whole << length + 2.0 * radius;
  capsule->SetAttribute("length", whole.str().c_str());
}

}  // namespace

std::optional<double> FiniteNumber(std::string_view text) {
  // istream, which urdfdom reads with, takes a plus sign; ParseAs does not.
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  const std::optional<double> number = ParseAs<double>(text);
  return number && std::isfinite(*number) ? number : std::nullopt;
}

std::string FaultOfNumbers(TiXmlElement* element, const char* attribute, std::size_t count,
                           double most) {
  if (element->Attribute(attribute) == nullptr) return "";
  std::istringstream text(TextOf(*element, attribute));
  std::string joined;
  std::size_t found = 0;
  bool is_number = true, is_small = true;
  for (std::string word; text >> word; ++found) {
    const std::optional<double> number = FiniteNumber(word);
    is_number = is_number && number;
    is_small = is_small && std::abs(number.value_or(0.0)) <= most;
    joined += (found > 0 ? " " : "") + word;
  }
  if (is_number && is_small && found == count) {
    element->SetAttribute(attribute, joined.c_str());
    return "";
  }
  constexpr std::size_t kMostTold = 60;  // characters of a value
  std::ostringstream fault;
  fault << "has " << attribute << " = '" << joined.substr(0, kMostTold) << "' in <"
        << element->ValueStr() << ">, which must be ";
  if (is_number && found == count) {
    fault << "at most " << most;
  } else {
    fault << (count == 1 ? "a finite number" : std::to_string(count) + " finite numbers");
    if (joined.find("${") != std::string::npos) fault << "; expand the file with xacro first";
  }
  return fault.str();
}

std::string FaultOfOrigin(TiXmlElement* parent) {
  TiXmlElement* const origin = parent->FirstChildElement("origin");
  if (origin == nullptr) return "";
  const std::string fault = FaultOfNumbers(origin, "xyz", 3, kMaxUrdfLength_m);
  return fault.empty() ? FaultOfNumbers(origin, "rpy", 3, kMaxUrdfAngle_rad) : fault;
}

std::string FaultOfShape(TiXmlElement* owner) {
  if (std::string fault = FaultOfOrigin(owner); !fault.empty()) return fault;
  TiXmlElement* const geometry = owner->FirstChildElement("geometry");
  TiXmlElement* shape = geometry != nullptr ? geometry->FirstChildElement() : nullptr;
  if (shape == nullptr) return "has a " + Tag(*owner) + " without a shape";
  if (shape->ValueStr() == "box") return FaultOfSize(shape, "size", 3);
  if (shape->ValueStr() == "sphere") return FaultOfSize(shape, "radius", 1);
  if (shape->ValueStr() == "cylinder" || shape->ValueStr() == "capsule") {
    std::string fault = FaultOfSize(shape, "radius", 1);
    if (fault.empty()) fault = FaultOfSize(shape, "length", 1);
    if (fault.empty() && shape->ValueStr() == "capsule") MakeCylinder(shape);
    return fault;
  }
  if (shape->ValueStr() != "mesh") {
    return "has the shape " + Tag(*shape) + ", which is none of box, sphere, cylinder, mesh";
  }
  if (TextOf(*shape, "filename").empty()) return "has a <mesh> without filename";
  return FaultOfNumbers(shape, "scale", 3, kMaxUrdfNumber);
}

}  // namespace sidestep
