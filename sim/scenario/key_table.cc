// SPDX-License-Identifier: BSD-3-Clause
#include "sim/scenario/key_table.h"

#include <algorithm>
#include <cstdint>
#include <sstream>
#include <type_traits>

#include "models/support/config_error.h"
#include "models/support/nearest_name.h"
#include "sim/scenario/based_on.h"
#include "sim/scenario/scenario.h"
#include "sim/scenario/yaml_writer.h"

namespace sidestep {
namespace {

/// The visitor: appends a KeyInfo for every line of a table. The fields' values are the defaults.
class KeyCollector {
 public:
  explicit KeyCollector(std::vector<KeyInfo>* keys) : keys_(keys) {}

  void operator()(const char* key, double field, Range range, Meaning meaning) {
    Add(key, KeyKind::kNumber, range, NumberText(field), meaning);
  }
  void operator()(const char* key, int field, Range range, Meaning meaning) {
    Add(key, KeyKind::kInteger, range, std::to_string(field), meaning);
  }
  void operator()(const char* key, const Eigen::Vector3d& field, Range range, Meaning meaning) {
    Add(key, KeyKind::kVector, range, YamlVector(field), meaning);
  }
  void operator()(const char* key, const PixelSize& size, Range range, Meaning meaning) {
    Add(key, KeyKind::kPixelSize, range, YamlSize(size), meaning);
  }
  template <typename T>
  void operator()(const char* key, const std::optional<T>& /*field*/, Range range,
                  Meaning meaning) {
    (*this)(key, T(), range, meaning);
    keys_->back().default_value.clear();
  }
  template <typename T>
  void operator()(const char* key, const std::optional<T>& /*field*/, Meaning meaning) {
    (*this)(key, T(), meaning);
    keys_->back().default_value.clear();
  }
  void operator()(const char* key, const StridePhase& /*field*/, Range range, Meaning meaning) {
    Add(key, KeyKind::kNumberOrChoice, range, "", meaning);
    for (const auto& entry : EnumNames<PhaseName>::kNames) {
      keys_->back().choices.emplace_back(entry.second);
    }
  }
  void operator()(const char* key, std::uint64_t field, Meaning meaning) {
    Add(key, KeyKind::kInteger, std::to_string(field), meaning).min = 0.0;
  }

  // Sections whose values files spell in a form of their own.
  void operator()(const char* key, const std::vector<GaitParams>& /*field*/, Meaning meaning) {
    AddMap(key, KeyKind::kMapOrList, GaitParams(), meaning);
  }
  void operator()(const char* key, const std::vector<Push>& /*field*/, Meaning meaning) {
    AddMap(key, KeyKind::kPushes, PushEntry(), meaning);
  }
  void operator()(const char* key, const std::vector<Expectation>& /*field*/, Meaning meaning) {
    Add(key, KeyKind::kMetricsMap, "", meaning);
  }
  void operator()(const char* key, const VideoParams& field, Meaning meaning) {
    AddMap(key, KeyKind::kMapOrBool, field, meaning);
  }

  template <typename T>
  void operator()(const char* key, const std::vector<T>& /*field*/, Meaning meaning) {
    AddMap(key, KeyKind::kList, T(), meaning);
  }
  template <typename T>
  void operator()(const char* key, const T& field, Meaning meaning) {
    if constexpr (std::is_same_v<T, bool>) {
      Add(key, KeyKind::kBool, field ? "true" : "false", meaning);
    } else if constexpr (std::is_same_v<T, std::string>) {
      Add(key, KeyKind::kText, field, meaning);
    } else if constexpr (std::is_enum_v<T>) {
      KeyInfo& info = Add(key, KeyKind::kChoice, std::string(EnumName(field)), meaning);
      for (const auto& entry : EnumNames<T>::kNames) info.choices.emplace_back(entry.second);
    } else {
      AddMap(key, KeyKind::kMap, field, meaning);
    }
  }

 private:
  KeyInfo& Add(const char* key, KeyKind kind, const std::string& default_value, Meaning meaning) {
    KeyInfo& info = keys_->emplace_back();
    info.name = key;
    info.kind = kind;
    info.is_required = meaning.is_required;
    if (!meaning.is_required) info.default_value = default_value;
    info.meaning = meaning.text;
    return info;
  }

  void Add(const char* key, KeyKind kind, Range range, const std::string& default_value,
           Meaning meaning) {
    KeyInfo& info = Add(key, kind, default_value, meaning);
    info.min = range.min;
    info.max = range.max;
    info.excludes_min = range.excludes_min;
  }

  template <typename T>
  void AddMap(const char* key, KeyKind kind, const T& field, Meaning meaning) {
    KeyInfo& info = Add(key, kind, "", meaning);
    T::VisitFields(field, KeyCollector(&info.children));
  }

  std::vector<KeyInfo>* keys_;
};

bool IsIndex(const std::string& part) {
  return !part.empty() && part.find_first_not_of("0123456789") == std::string::npos;
}

bool IsListOfMaps(const KeyInfo& key) {
  return key.kind == KeyKind::kList || key.kind == KeyKind::kPushes ||
         key.kind == KeyKind::kMapOrList;
}

}  // namespace

KeyInfo ScenarioKeys() {
  KeyInfo root;
  root.meaning = "a push-recovery scenario of Sidestep";
  const Scenario defaults;
  ScenarioBasics::VisitFields(defaults, KeyCollector(&root.children));
  const BasedOn base;
  BasedOn::VisitFields(base, KeyCollector(&root.children));
  Scenario::VisitSections(defaults, KeyCollector(&root.children));
  return root;
}

const KeyInfo& FindKey(const KeyInfo& root, const std::string& path) {
  const KeyInfo* key = &root;
  std::string walked;
  std::istringstream parts(path);
  for (std::string part; std::getline(parts, part, '.');) {
    if (part.ends_with("[]")) part.resize(part.size() - 2);
    if (IsIndex(part) && IsListOfMaps(*key)) continue;
    std::vector<std::string> names;
    for (const KeyInfo& child : key->children) names.push_back(child.name);
    const auto found = std::find(names.begin(), names.end(), part);
    walked += (walked.empty() ? "" : ".") + part;
    if (found == names.end()) {
      throw ConfigError("error: " + walked + " is not a known key; " +
                        DidYouMean(part, names, "known keys"));
    }
    key = &key->children[static_cast<std::size_t>(found - names.begin())];
  }
  return *key;
}

std::string KeyPath(const std::string& parent_path, const KeyInfo& parent, const KeyInfo& key) {
  if (parent_path.empty()) return key.name;
  return parent_path + (IsListOfMaps(parent) ? "[]." : ".") + key.name;
}

}  // namespace sidestep
