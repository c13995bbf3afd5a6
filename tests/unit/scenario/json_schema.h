// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// json_schema: checks a YAML document against the part of JSON Schema that our schema uses.

#include <gtest/gtest.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "models/support/config_tree.h"

namespace sidestep {

/// The document as JSON: plain scalars that look like numbers or truth values are such.
inline nlohmann::json JsonOf(const ConfigTree& tree) {
  switch (tree.kind) {
    case ConfigKind::kNull:
      return nullptr;
    case ConfigKind::kMap: {
      nlohmann::json map = nlohmann::json::object();
      for (std::size_t i = 0; i < tree.keys.size(); ++i) {
        map[tree.keys[i].text] = JsonOf(tree.children[i]);
      }
      return map;
    }
    case ConfigKind::kList: {
      nlohmann::json list = nlohmann::json::array();
      for (const ConfigTree& child : tree.children) list.push_back(JsonOf(child));
      return list;
    }
    case ConfigKind::kScalar:
      break;
  }
  const std::string& text = tree.scalar;
  if (tree.is_quoted) return text;
  if (text == "true" || text == "false") return text == "true";
  const char* const end = text.data() + text.size();
  std::int64_t integer = 0;
  if (std::from_chars(text.data(), end, integer).ptr == end) return integer;
  double number = 0.0;
  if (std::from_chars(text.data(), end, number).ptr == end) return number;
  return text;
}

/// The first reason why `value` breaks `schema`, or "". A keyword that this checker does not know
/// is a test failure: nothing is skipped silently.
class JsonSchema {
 public:
  explicit JsonSchema(const std::string& text) : root_(nlohmann::json::parse(text)) {}

  std::string Fault(const nlohmann::json& value) const { return Fault(root_, value, "/"); }

 private:
  using Json = nlohmann::json;

  static bool HasType(const Json& value, const std::string& type) {
    if (type == "object") return value.is_object();
    if (type == "array") return value.is_array();
    if (type == "string") return value.is_string();
    if (type == "boolean") return value.is_boolean();
    if (type == "number") return value.is_number();
    if (type == "integer") return value.is_number_integer();
    ADD_FAILURE() << "unknown type " << type;
    return false;
  }

  static std::string Fault(const Json& schema, const Json& value, const std::string& path) {
    if (schema.is_boolean()) return schema.get<bool>() ? "" : path + " is forbidden";
    for (const auto& [word, rule] : schema.items()) {
      std::string fault = FaultOf(word, rule, schema, value, path);
      if (!fault.empty()) return fault;
    }
    return "";
  }

  static std::string FaultOf(const std::string& word, const Json& rule, const Json& schema,
                             const Json& value, const std::string& path) {
    static const std::set<std::string> kNotes{"$schema", "title", "description", "default"};
    if (kNotes.contains(word)) return "";
    bool is_good = true;
    if (word == "type") {
      const Json types = rule.is_array() ? rule : Json::array({rule});
      is_good = std::any_of(types.begin(), types.end(),
                            [&](const Json& type) { return HasType(value, type); });
    } else if (word == "enum") {
      is_good = std::find(rule.begin(), rule.end(), value) != rule.end();
    } else if (word == "minimum") {
      is_good = !value.is_number() || value.get<double>() >= rule.get<double>();
    } else if (word == "exclusiveMinimum") {
      is_good = !value.is_number() || value.get<double>() > rule.get<double>();
    } else if (word == "maximum") {
      is_good = !value.is_number() || value.get<double>() <= rule.get<double>();
    } else if (word == "multipleOf") {
      is_good = !value.is_number_integer() || value.get<int>() % rule.get<int>() == 0;
    } else if (word == "minItems") {
      is_good = !value.is_array() || value.size() >= rule.get<std::size_t>();
    } else if (word == "maxItems") {
      is_good = !value.is_array() || value.size() <= rule.get<std::size_t>();
    } else if (word == "minProperties") {
      is_good = !value.is_object() || value.size() >= rule.get<std::size_t>();
    } else if (word == "required") {
      is_good = !value.is_object() || std::all_of(rule.begin(), rule.end(), [&](const Json& key) {
        return value.contains(key.get<std::string>());
      });
    } else if (word == "anyOf") {
      is_good = std::any_of(rule.begin(), rule.end(),
                            [&](const Json& each) { return Fault(each, value, path).empty(); });
    } else if (word == "oneOf") {
      is_good = std::count_if(rule.begin(), rule.end(), [&](const Json& each) {
                  return Fault(each, value, path).empty();
                }) == 1;
    } else {
      return FaultInside(word, rule, schema, value, path);
    }
    return is_good ? "" : path + " breaks " + word + " " + rule.dump();
  }

  static std::string FaultInside(const std::string& word, const Json& rule, const Json& schema,
                                 const Json& value, const std::string& path) {
    if (word == "items" && value.is_array()) {
      for (std::size_t i = 0; i < value.size(); ++i) {
        std::string fault = Fault(rule, value[i], path + std::to_string(i) + "/");
        if (!fault.empty()) return fault;
      }
    } else if ((word == "properties" || word == "additionalProperties") && value.is_object()) {
      const auto properties = schema.find("properties");
      for (const auto& [key, each] : value.items()) {
        const bool is_known = properties != schema.end() && properties->contains(key);
        if (is_known != (word == "properties")) continue;
        std::string fault = Fault(is_known ? rule[key] : rule, each, path + key + "/");
        if (!fault.empty()) return fault;
      }
    } else if (word != "items" && word != "properties" && word != "additionalProperties") {
      ADD_FAILURE() << "this checker does not know " << word;
    }
    return "";
  }

  nlohmann::json root_;
};

}  // namespace sidestep
