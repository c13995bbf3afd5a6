// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/plain_names.h"

#include <algorithm>
#include <string>
#include <vector>

#include "models/import/text.h"
#include "models/support/plain_word.h"

namespace sidestep::importer {
namespace {

constexpr std::size_t kMostLetters = 90;  // leaves room for what makes it differ, and for _fixed

/// `name` without what is around it, and with what is inside it and not plain as '_'.
std::string NearestPlainWord(const std::string& name) {
  const std::size_t first = name.find_first_not_of(" \t\r\n-.");
  if (first == std::string::npos) return "unnamed";
  const std::size_t last = name.find_last_not_of(" \t\r\n");
  return PlainCharactersOf(name.substr(first, std::min(last - first + 1, kMostLetters)));
}

}  // namespace

void MakeNamesPlain(SourceRobot* robot, Notes* notes) {
  std::vector<std::string> renamed;
  const auto mend = [&](std::string* name) {
    if (IsPlainWord(*name)) return;
    const std::string plain = UnusedName(*robot, NearestPlainWord(*name));
    renamed.push_back(*name + "' to '" + plain);
    *name = plain;
  };
  for (SourceLink& link : robot->links) mend(&link.name);
  for (SourceJoint& joint : robot->joints) mend(&joint.name);
  if (!renamed.empty()) {
    notes->push_back("renamed " + Listed(renamed) +
                     ": names are of letters, digits, '_', '-', '.'");
  }
}

}  // namespace sidestep::importer
