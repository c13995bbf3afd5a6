// SPDX-License-Identifier: BSD-3-Clause
#include "sim/export/mat_names.h"

#include <cstddef>

namespace sidestep {
namespace {

constexpr std::size_t kLongest = 63;  // namelengthmax of MATLAB
constexpr std::size_t kNumberRoom = 8;

bool IsLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

std::string Cleaned(const std::string& text) {
  std::string name;
  for (const char c : text) name += IsLetter(c) || (c >= '0' && c <= '9') ? c : '_';
  if (name.empty() || !IsLetter(name.front())) name.insert(name.begin(), 'x');
  if (name == "data" || name == "log") name += '_';
  return name.substr(0, kLongest - kNumberRoom);
}

}  // namespace

std::string MatNames::Take(const std::string& text) {
  const std::string cleaned = Cleaned(text);
  std::string name = cleaned;
  for (int number = 2; !taken_.insert(name).second; ++number) {
    name = cleaned + "_" + std::to_string(number);
  }
  return name;
}

}  // namespace sidestep
