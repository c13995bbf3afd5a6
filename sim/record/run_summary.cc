// SPDX-License-Identifier: BSD-3-Clause
#include "sim/record/run_summary.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <type_traits>

#include "models/support/config_error.h"
#include "models/support/json_text.h"
#include "sim/record/run_reader.h"

namespace sidestep {
namespace {

using Json = nlohmann::ordered_json;  // keeps the order of the keys

using VersionList = std::vector<std::pair<std::string, std::string>>;

// --- Writing. The library writes null for NaN and infinity. ---

template <typename T>
Json ToJson(const T& value);

template <typename T>
Json ToJson(const std::optional<T>& value) {
  return value ? Json(*value) : Json(nullptr);
}

template <typename T>
Json ToJson(const std::vector<T>& values) {
  Json list = Json::array();
  for (const T& value : values) list.push_back(ToJson(value));
  return list;
}

Json ToJson(const MetricValue& value) {
  return std::visit([](auto held) { return Json(held); }, value);
}

Json ToJson(const Metrics& metrics) {
  Json object = Json::object();
  for (const auto& [name, value] : metrics) object[name] = ToJson(value);
  return object;
}

Json ToJson(const VersionList& versions) {
  Json object = Json::object();
  for (const auto& [name, version] : versions) object[name] = version;
  return object;
}

Json ToJson(const std::vector<JointSummary>& joints) {
  Json object = Json::object();
  for (const JointSummary& joint : joints) object[joint.name] = ToJson(joint);
  return object;
}

template <typename T>
Json ToJson(const T& value) {
  if constexpr (std::is_enum_v<T>) {
    return EnumName(value);
  } else if constexpr (std::is_arithmetic_v<T> || std::is_same_v<T, std::string>) {
    return value;
  } else {
    Json object = Json::object();
    T::VisitFields(
        value, [&](const char* key, const auto& field, auto...) { object[key] = ToJson(field); });
    return object;
  }
}

// --- Reading. ---

// A key as an error shows it: on one line, and not a whole hostile file.
std::string Shown(const std::string& key) {
  constexpr std::size_t kLongest = 60;
  std::string shown = key.substr(0, kLongest);
  std::replace_if(
      shown.begin(), shown.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  return key.size() > kLongest ? shown + ".." : shown;
}

/// A value of the document and its path, for the errors.
struct Node {
  const Json& value;
  std::string path;
  const std::filesystem::path& file;

  [[noreturn]] void Fail(const std::string& expected) const {
    throw ConfigError(file.string() + ": error: " + (path.empty() ? "the file" : path) +
                      ": expected " + expected + ", got " + value.type_name());
  }
  void Require(bool is_right, const char* expected) const {
    if (!is_right) Fail(expected);
  }
  bool has(const std::string& key) const { return value.contains(key); }
  Node operator[](const std::string& key) const {
    const std::string inner = path.empty() ? Shown(key) : path + "." + Shown(key);
    if (!has(key)) throw ConfigError(file.string() + ": error: " + inner + " is missing");
    return {value.at(key), inner, file};
  }
  Node operator[](std::size_t index) const {
    return {value.at(index), path + "[" + std::to_string(index) + "]", file};
  }
};

template <typename T>
void FromJson(const Node& node, T* value);

void FromJson(const Node& node, std::string* value) {
  node.Require(node.value.is_string(), "a string");
  *value = node.value.get<std::string>();
}

void FromJson(const Node& node, bool* value) {
  node.Require(node.value.is_boolean(), "true or false");
  *value = node.value.get<bool>();
}

void FromJson(const Node& node, double* value) {
  node.Require(node.value.is_number() || node.value.is_null(), "a number or null");
  *value = node.value.is_null() ? kNotTold : node.value.get<double>();
}

void FromJson(const Node& node, int* value) {
  node.Require(node.value.is_number_unsigned() &&
                   node.value.get<std::uint64_t>() <=
                       static_cast<std::uint64_t>(std::numeric_limits<int>::max()),
               "a count");
  *value = node.value.get<int>();
}

void FromJson(const Node& node, std::uint64_t* value) {
  node.Require(node.value.is_number_unsigned(), "a whole number from 0 to 2^64 - 1");
  *value = node.value.get<std::uint64_t>();
}

void FromJson(const Node& node, MetricValue* value) {
  if (node.value.is_boolean()) {
    *value = node.value.get<bool>();
    return;
  }
  node.Require(node.value.is_number() || node.value.is_null(), "a number, true, false or null");
  *value = node.value.is_null() ? kNotTold : node.value.get<double>();
}

template <typename T>
void FromJson(const Node& node, std::optional<T>* value) {
  if (node.value.is_null()) {
    value->reset();
  } else {
    FromJson(node, &value->emplace());
  }
}

template <typename T>
void FromJson(const Node& node, std::vector<T>* values) {
  node.Require(node.value.is_array(), "a list");
  values->assign(node.value.size(), T());
  for (std::size_t i = 0; i < values->size(); ++i) FromJson(node[i], &(*values)[i]);
}

void FromJson(const Node& node, Metrics* metrics) {
  node.Require(node.value.is_object(), "an object");
  for (const auto& item : node.value.items()) FromJson(node[item.key()], &(*metrics)[item.key()]);
}

void FromJson(const Node& node, VersionList* versions) {
  node.Require(node.value.is_object(), "an object");
  for (const auto& item : node.value.items()) {
    FromJson(node[item.key()], &versions->emplace_back(item.key(), "").second);
  }
}

void FromJson(const Node& node, std::vector<JointSummary>* joints) {
  node.Require(node.value.is_object(), "an object");
  for (const auto& item : node.value.items()) {
    JointSummary& joint = joints->emplace_back();
    joint.name = item.key();
    const Node of_joint = node[item.key()];
    joint.is_slide = of_joint.has(JointSummary::kSlideKey);
    FromJson(of_joint, &joint);
  }
}

template <typename Enum>
void ReadEnum(const Node& node, Enum* value) {
  std::string expected;
  for (const auto& [candidate, name] : EnumNames<Enum>::kNames) {
    if (node.value.is_string() && node.value.get_ref<const std::string&>() == name) {
      *value = candidate;
      return;
    }
    expected += (expected.empty() ? "" : " or ") + std::string(name);
  }
  node.Fail(expected);
}

template <typename T>
void FromJson(const Node& node, T* value) {
  if constexpr (std::is_enum_v<T>) {
    ReadEnum(node, value);
  } else {
    node.Require(node.value.is_object(), "an object");
    T::VisitFields(*value, [&](const char* key, auto& field, auto... added_later) {
      constexpr bool kMayBeAbsent = sizeof...(added_later) > 0;
      if (!kMayBeAbsent || node.has(key)) FromJson(node[key], &field);
    });
  }
}

}  // namespace

std::string SummaryJson(const RunSummary& summary) {
  return ToJson(summary).dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

RunSummary ParseSummary(const std::string& text, const std::filesystem::path& file) {
  const Json document = ParseJson<Json>(text, file.string());
  RunSummary summary;
  FromJson(Node{document, "", file}, &summary);
  return summary;
}

RunSummary ReadSummary(const std::filesystem::path& run_dir) {
  const std::filesystem::path file = run_dir / "summary.json";
  return ParseSummary(ReadWholeFile(file), file);
}

}  // namespace sidestep
