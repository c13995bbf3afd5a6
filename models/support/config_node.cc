// SPDX-License-Identifier: BSD-3-Clause
#include "models/support/config_node.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <sstream>
#include <system_error>
#include <utility>

#include "models/support/config_error.h"
#include "models/support/nearest_name.h"
#include "models/support/plain_word.h"

namespace sidestep {
namespace {

bool IsIndex(std::string_view text) {
  return !text.empty() &&
         std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

/// The last part of a path, together with the part before it if it is an index.
std::string ShortName(const std::string& path) {
  std::size_t dot = path.rfind('.');
  if (dot != std::string::npos && IsIndex(std::string_view(path).substr(dot + 1)) && dot > 0) {
    dot = path.rfind('.', dot - 1);
  }
  return dot == std::string::npos ? path : path.substr(dot + 1);
}

std::string Describe(const ConfigTree& tree) {
  switch (tree.kind) {
    case ConfigKind::kNull:
      return "empty";
    case ConfigKind::kScalar:
      return "'" + tree.scalar + "'";
    case ConfigKind::kList:
      return "a list";
    case ConfigKind::kMap:
      return "a map";
  }
  return "";
}

/// The text of a plain (unquoted) scalar without a leading '+'.
std::string_view PlainDigits(const ConfigNode& node, const std::string& wanted) {
  const ConfigTree& tree = node.tree();
  if (tree.kind != ConfigKind::kScalar) node.Fail("must be " + wanted + ", not " + Describe(tree));
  if (tree.is_quoted) node.Fail("= '" + tree.scalar + "' is quoted text, not " + wanted);
  std::string_view text = tree.scalar;
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  return text;
}

template <typename T>
std::string RangeRule(const std::string& path, const std::string& value, T min, T max) {
  std::ostringstream rule;
  rule << "= " << value << " violates " << NumberText(static_cast<double>(min))
       << " <= " << ShortName(path) << " <= ";
  if constexpr (std::is_integral_v<T>) {
    rule << max;  // the largest 64-bit integers are no doubles
  } else {
    rule << NumberText(max);
  }
  return rule.str();
}

/// The part of a map or list called `part`, or null.
const ConfigTree* ChildOf(const ConfigTree& tree, const std::string& part) {
  if (tree.kind != ConfigKind::kList) return tree.Find(part);
  if (!IsIndex(part) || part.size() > 9) return nullptr;
  const std::size_t index = std::stoul(part);
  return index < tree.children.size() ? &tree.children[index] : nullptr;
}

}  // namespace

std::string NumberText(double value) {
  std::array<char, 32> buffer{};
  const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  return {buffer.data(), result.ptr};
}

double ConfigNode::Number(double min, double max) const {
  const std::string_view text = PlainDigits(*this, "a number");
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool is_yaml_special = text == ".nan" || text == ".inf" || text == "-.inf";
  if (!is_yaml_special &&
      (error == std::errc::invalid_argument || end != text.data() + text.size())) {
    Fail("= '" + tree_->scalar + "' is not a number");
  }
  if (is_yaml_special || error != std::errc() || !std::isfinite(value)) {
    Fail("= '" + tree_->scalar + "' is not a finite number");
  }
  if (!(min <= value && value <= max)) Fail(RangeRule(path_, NumberText(value), min, max));
  return value;
}

std::int64_t ConfigNode::Integer(std::int64_t min, std::int64_t max) const {
  const std::string_view text = PlainDigits(*this, "an integer");
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc::invalid_argument || end != text.data() + text.size()) {
    Fail("= '" + tree_->scalar + "' is not an integer");
  }
  const bool in_range = error == std::errc() && min <= value && value <= max;
  if (!in_range) Fail(RangeRule(path_, std::string(text), min, max));
  return value;
}

bool ConfigNode::is_bool() const {
  const bool is_plain = tree_->kind == ConfigKind::kScalar && !tree_->is_quoted;
  return is_plain && (tree_->scalar == "true" || tree_->scalar == "false");
}

bool ConfigNode::Bool() const {
  if (!is_bool()) Fail("must be true or false, not " + Describe(*tree_));
  return tree_->scalar == "true";
}

std::string ConfigNode::Text() const {
  if (tree_->kind != ConfigKind::kScalar) Fail("must be text, not " + Describe(*tree_));
  return tree_->scalar;
}

std::string ConfigNode::Word() const {
  std::string name = Text();
  if (!IsPlainWord(name)) Fail("= '" + name + "' must be " + std::string(kPlainWordRule));
  return name;
}

std::size_t ConfigNode::Choice(std::span<const std::string> names) const {
  const std::string value = Text();
  const auto found = std::find(names.begin(), names.end(), value);
  if (found == names.end()) {
    Fail("= '" + value + "' is not known; " + DidYouMean(value, names, "known values"));
  }
  return static_cast<std::size_t>(found - names.begin());
}

Eigen::Vector3d ConfigNode::Vector3(double min, double max) const {
  const bool is_triple = tree_->kind == ConfigKind::kList && tree_->children.size() == 3;
  if (!is_triple) {
    const bool is_list = tree_->kind == ConfigKind::kList;
    Fail("must be a list of 3 numbers, not " +
         (is_list ? "of " + std::to_string(tree_->children.size()) : Describe(*tree_)));
  }
  Eigen::Vector3d value;
  const std::vector<ConfigNode> elements = List();
  for (std::size_t i = 0; i < 3; ++i) {
    value[static_cast<Eigen::Index>(i)] = elements[i].Number(min, max);
  }
  return value;
}

std::vector<ConfigNode> ConfigNode::List() const {
  if (tree_->kind != ConfigKind::kList) Fail("must be a list, not " + Describe(*tree_));
  std::vector<ConfigNode> elements;
  elements.reserve(tree_->children.size());
  for (const ConfigTree& child : tree_->children) {
    elements.emplace_back(child, path_ + "." + std::to_string(elements.size()));
  }
  return elements;
}

ConfigMap ConfigNode::Map() const { return {*tree_, path_}; }

void ConfigNode::Fail(const std::string& what) const { FailAt(tree_->place, path_ + " " + what); }

ConfigMap::ConfigMap(const ConfigTree& tree, const std::string& path) : tree_(&tree), path_(path) {
  if (tree.kind != ConfigKind::kMap) Fail("must be a map of keys, not " + Describe(tree));
}

ConfigNode ConfigMap::Required(const std::string& key) {
  std::optional<ConfigNode> node = Optional(key);
  if (node) return *std::move(node);
  const std::array<std::string, 1> wanted{key};
  for (const ConfigKey& other : tree_->keys) {
    if (std::find(known_.begin(), known_.end(), other.text) != known_.end()) continue;
    if (NearestName(other.text, wanted).empty()) continue;
    known_.push_back(other.text);  // told here, and not again as unknown
    FailAtKey(other.text, "is not a known key; did you mean '" + key + "'?");
  }
  FailAt(tree_->place, PathOf(key) + " is missing (required)");
}

std::optional<ConfigNode> ConfigMap::Optional(const std::string& key) {
  if (std::find(known_.begin(), known_.end(), key) == known_.end()) known_.push_back(key);
  const ConfigTree* child = tree_->Find(key);
  if (child == nullptr) return std::nullopt;
  return ConfigNode(*child, PathOf(key));
}

std::vector<std::string> ConfigMap::Keys() const {
  std::vector<std::string> keys;
  for (const ConfigKey& key : tree_->keys) keys.push_back(key.text);
  return keys;
}

void ConfigMap::RejectUnknownKeys() const {
  Mistakes mistakes;
  for (const ConfigKey& key : tree_->keys) {
    if (std::find(known_.begin(), known_.end(), key.text) != known_.end()) continue;
    mistakes.Try([&] {
      FailAtKey(key.text, "is not a known key; " + DidYouMean(key.text, known_, "known keys"));
    });
  }
  mistakes.Throw();
}

void ConfigMap::FailAtKey(const std::string& key, const std::string& what) const {
  for (const ConfigKey& candidate : tree_->keys) {
    if (candidate.text == key) FailAt(candidate.place, PathOf(key) + " " + what);
  }
  Fail(what);
}

void ConfigMap::Fail(const std::string& what) const {
  FailAt(tree_->place, (path_.empty() ? "the file" : path_) + " " + what);
}

std::string ConfigMap::PathOf(const std::string& key) const {
  return path_.empty() ? key : path_ + "." + key;
}

const ConfigTree* FindPath(const ConfigTree& root, const std::string& path) {
  const ConfigTree* tree = &root;
  std::istringstream parts(path);
  for (std::string part; tree != nullptr && std::getline(parts, part, '.');) {
    tree = ChildOf(*tree, part);
  }
  return tree;
}

void FailAtPath(const ConfigTree& root, const std::string& path, const std::string& what) {
  std::string part = path;
  const ConfigTree* tree = FindPath(root, part);
  while (tree == nullptr) {
    const std::size_t dot = part.rfind('.');
    part.resize(dot == std::string::npos ? 0 : dot);
    tree = FindPath(root, part);
  }
  FailAt(tree->place, path + " " + what);
}

}  // namespace sidestep
