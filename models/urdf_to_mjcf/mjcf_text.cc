// SPDX-License-Identifier: BSD-3-Clause
#include "models/urdf_to_mjcf/mjcf_text.h"

#include <array>
#include <charconv>
#include <map>

namespace sidestep {
namespace {

std::string Escaped(const std::string& name) {
  std::string text;
  for (const char c : name) {
    const std::map<char, std::string> escapes{
        {'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}};
    const auto escape = escapes.find(c);
    text += escape == escapes.end() ? std::string(1, c) : escape->second;
  }
  return text;
}

}  // namespace

std::string Numbers(const double* values, Eigen::Index count) {
  std::string text;
  for (Eigen::Index i = 0; i < count; ++i) {
    std::array<char, 40> digits{};
    const auto [end, error] =
        std::to_chars(digits.data(), digits.data() + digits.size(), values[i]);
    text += (i > 0 ? " " : "") + std::string(digits.data(), end);
  }
  return text;
}

std::string Numbers(const Eigen::VectorXd& values) { return Numbers(values.data(), values.size()); }
std::string Number(double value) { return Numbers(&value, 1); }

std::string Attribute(const std::string& name, const std::string& value) {
  return " " + name + "=\"" + Escaped(value) + "\"";
}

std::string PoseAttributes(const Eigen::Isometry3d& X) {
  const Eigen::Quaterniond q(X.rotation());
  const Eigen::Vector4d wxyz(q.w(), q.x(), q.y(), q.z());
  return Attribute("pos", Numbers(X.translation())) + Attribute("quat", Numbers(wxyz));
}

}  // namespace sidestep
