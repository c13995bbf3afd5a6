// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/side_names.h"

#include <cctype>
#include <set>
#include <vector>

namespace sidestep::importer {
namespace {

bool IsUpper(char c) { return std::isupper(static_cast<unsigned char>(c)) != 0; }
bool IsAlpha(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }

/// Words of a name: parted where letters end, and before a capital that begins a word (LHip: L,
/// Hip; leftKnee: left, Knee), in small letters.
std::vector<std::string> Words(const std::string& name) {
  std::vector<std::string> words(1);
  for (std::size_t i = 0; i < name.size(); ++i) {
    if (!IsAlpha(name[i])) {
      words.emplace_back();
      continue;
    }
    const bool follows_small = i > 0 && IsAlpha(name[i - 1]) && !IsUpper(name[i - 1]);
    const bool precedes_small =
        i + 1 < name.size() && IsAlpha(name[i + 1]) && !IsUpper(name[i + 1]);
    if (IsUpper(name[i]) && (follows_small || precedes_small)) words.emplace_back();
    words.back() += static_cast<char>(std::tolower(static_cast<unsigned char>(name[i])));
  }
  return words;
}

}  // namespace

int SideInName(const std::string& name) {
  static const std::set<std::string> kLeft{"left", "l", "fl", "lf", "lft"};
  static const std::set<std::string> kRight{"right", "r", "fr", "rf", "rgt"};
  bool is_left = false, is_right = false;
  for (const std::string& word : Words(name)) {
    is_left = is_left || kLeft.count(word) > 0 || word.rfind("left", 0) == 0;
    is_right = is_right || kRight.count(word) > 0 || word.rfind("right", 0) == 0;
  }
  return is_left == is_right ? 0 : is_left ? 1 : -1;
}

int LegInName(const std::string& name) {
  static const std::set<std::string> kLeg{"leg",  "hip",   "thigh", "knee", "shank", "calf",
                                          "shin", "ankle", "foot",  "toe",  "sole",  "haa"};
  static const std::set<std::string> kArm{"arm",   "shoulder", "elbow", "forearm",
                                          "wrist", "hand",     "palm",  "gripper"};
  bool is_leg = false, is_arm = false;
  for (const std::string& word : Words(name)) {
    is_leg = is_leg || kLeg.count(word) > 0;
    is_arm = is_arm || kArm.count(word) > 0;
  }
  return is_leg == is_arm ? 0 : is_leg ? 1 : -1;
}

}  // namespace sidestep::importer
