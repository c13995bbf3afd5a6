// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/mjcf_schema.h"

#include <mujoco/mujoco.h>

#include <sstream>
#include <vector>

#include "models/support/require.h"

namespace sidestep::importer {
namespace {

constexpr std::size_t kBufferSize = 1U << 18U;  // it prints 20 kB
constexpr std::size_t kIndent = 3;              // blanks a level

std::string PrintedSchema() {
  std::vector<char> text(kBufferSize);
  const int length = mj_printSchema(nullptr, text.data(), static_cast<int>(text.size()), 0, 0);
  SIDESTEP_REQUIRE(length > 0, length);
  return text.data();
}

/// "(!)", "(?)", "(*)" or "(R)": how often an element may be there.
bool IsCount(const std::string& word) {
  return word.size() == 3 && word.front() == '(' && word.back() == ')';
}

}  // namespace

MjcfSchema::MjcfSchema() {
  std::istringstream schema(PrintedSchema());
  std::vector<std::string> above{""};
  std::set<std::string>* attributes = nullptr;
  for (std::string line; std::getline(schema, line);) {
    std::istringstream stream(line);
    std::string first, second;
    stream >> first >> second;
    if (IsCount(second)) {
      const std::size_t level = line.find_first_not_of(' ') / kIndent;
      const std::string tag = first == "(world)body" ? "body" : first;
      above.resize(level + 1);
      attributes = &attributes_[{above.back(), tag}];
      above.push_back(tag);
    } else if (attributes != nullptr) {
      for (const std::string& word : {first, second}) {
        if (!word.empty()) attributes->insert(word);
      }
    }
    for (std::string word; attributes != nullptr && stream >> word;) attributes->insert(word);
  }
  attributes_[{"body", "body"}] = attributes_[{"mujoco", "body"}];
  attributes_[{"default", "default"}] = attributes_[{"mujoco", "default"}];
}

bool MjcfSchema::HasAttribute(const std::string& parent, const std::string& tag,
                              const std::string& attribute) const {
  const auto known = attributes_.find({parent, tag});
  return known != attributes_.end() && known->second.count(attribute) > 0;
}

}  // namespace sidestep::importer
