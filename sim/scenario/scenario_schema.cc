// SPDX-License-Identifier: BSD-3-Clause
#include "sim/scenario/scenario_schema.h"

#include <algorithm>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>

#include "controller/types/field.h"
#include "sim/scenario/based_on.h"
#include "sim/scenario/key_table.h"
#include "sim/verdict/metrics.h"

namespace sidestep {
namespace {

using Json = nlohmann::ordered_json;

Json SchemaOf(const KeyInfo& key);

/// A bound as an integer where it is one, so that 640 is not written 640.0.
Json BoundOf(double bound) {
  constexpr double kExact = 1e15;  // integers below are doubles, and 64 bits hold them
  const auto whole = static_cast<std::int64_t>(std::clamp(bound, -kExact, kExact));
  if (static_cast<double>(whole) == bound) return whole;
  return bound;
}

Json NumberSchema(const KeyInfo& key, const char* type) {
  Json schema{{"type", type}};
  if (key.min) schema[key.excludes_min ? "exclusiveMinimum" : "minimum"] = BoundOf(*key.min);
  if (key.max) schema["maximum"] = BoundOf(*key.max);
  return schema;
}

Json ListSchema(Json items, int size) {
  return {{"type", "array"}, {"items", std::move(items)}, {"minItems", size}, {"maxItems", size}};
}

/// Adds to `schema` what a map must look like.
void AddMap(const KeyInfo& map, Json* schema) {
  Json required = Json::array();
  for (const KeyInfo& child : map.children) {
    (*schema)["properties"][child.name] = SchemaOf(child);
    if (child.is_required) required.push_back(child.name);
  }
  if (!required.empty()) (*schema)["required"] = required;
  (*schema)["additionalProperties"] = false;
}

Json MapSchema(const KeyInfo& map, Json type = "object") {
  Json schema{{"type", std::move(type)}};
  AddMap(map, &schema);
  return schema;
}

/// One of the ways in which a push may tell its force and its start: these keys and none of
/// their rivals.
Json PushForm(const char* force, const char* start) {
  Json form{{"required", {force, start}}};
  for (const char* key : {"force_N", "magnitude_N", "magnitude_mg", "impulse_Nspkg"}) {
    if (std::string_view(key) != force) form["properties"][key] = false;
  }
  const bool has_direction = std::string_view(force) != "force_N";
  if (has_direction) form["required"].push_back("direction_rad");
  if (!has_direction) form["properties"]["direction_rad"] = false;
  for (const char* key : {"start_s", "at_phase"}) {
    if (std::string_view(key) != start) form["properties"][key] = false;
  }
  return form;
}

Json PushesSchema(const KeyInfo& pushes) {
  Json push = MapSchema(pushes);
  for (const char* force : {"force_N", "magnitude_N", "magnitude_mg", "impulse_Nspkg"}) {
    for (const char* start : {"start_s", "at_phase"}) {
      push["oneOf"].push_back(PushForm(force, start));
    }
  }
  return {{"type", "array"}, {"items", push}};
}

Json MetricsSchema() {
  Json schema{{"type", "object"}};
  for (const MetricInfo& metric : KnownMetrics()) {
    Json& expectation = schema["properties"][std::string(metric.name)];
    if (metric.is_bool) {
      expectation["type"] = "boolean";
    } else {
      expectation["type"] = {"number", "object"};
      expectation["properties"] = {{"min", {{"type", "number"}}}, {"max", {{"type", "number"}}}};
      expectation["minProperties"] = 1;
      expectation["additionalProperties"] = false;
    }
    const std::string unit = metric.unit.empty() ? "" : " [" + std::string(metric.unit) + "]";
    expectation["description"] = std::string(metric.meaning) + unit;
  }
  schema["additionalProperties"] = false;
  return schema;
}

Json ValueSchema(const KeyInfo& key) {
  switch (key.kind) {
    case KeyKind::kNumber:
      return NumberSchema(key, "number");
    case KeyKind::kInteger:
      return NumberSchema(key, "integer");
    case KeyKind::kVector:
      return ListSchema(NumberSchema(key, "number"), 3);
    case KeyKind::kPixelSize: {
      Json side = NumberSchema(key, "integer");
      side["multipleOf"] = 2;
      return ListSchema(std::move(side), 2);
    }
    case KeyKind::kBool:
      return {{"type", "boolean"}};
    case KeyKind::kText:
      return {{"type", "string"}};
    case KeyKind::kChoice:
      return {{"enum", key.choices}};
    case KeyKind::kNumberOrChoice:
      return {{"oneOf", {NumberSchema(key, "number"), {{"enum", key.choices}}}}};
    case KeyKind::kMap:
      return MapSchema(key);
    case KeyKind::kMapOrList: {
      Json schema = MapSchema(key, {"object", "array"});
      schema["items"] = MapSchema(key);
      schema["minItems"] = 1;
      return schema;
    }
    case KeyKind::kList:
      return {{"type", "array"}, {"items", MapSchema(key)}};
    case KeyKind::kPushes:
      return PushesSchema(key);
    case KeyKind::kMapOrBool:
      return MapSchema(key, {"object", "boolean"});
    case KeyKind::kMetricsMap:
      return MetricsSchema();
  }
  return {};
}

Json DefaultOf(const KeyInfo& key) {
  const bool is_text = key.kind == KeyKind::kText || key.kind == KeyKind::kChoice;
  return is_text ? Json(key.default_value) : Json::parse(key.default_value);
}

Json SchemaOf(const KeyInfo& key) {
  const std::string unit(UnitOf(key.name));
  Json schema = ValueSchema(key);
  schema["description"] = key.meaning + (unit.empty() ? "" : " [" + unit + "]");
  if (!key.default_value.empty()) schema["default"] = DefaultOf(key);
  return schema;
}

/// A file that is based on another needs only what it never has from there.
void LeaveToBase(Json* schema) {
  Json by_itself{{"required", Json::array()}};
  Json always = Json::array();
  for (const Json& key : (*schema)["required"]) {
    const bool is_own = key == "sidestep" || key == "name";
    (is_own ? always : by_itself["required"]).push_back(key);
  }
  (*schema)["required"] = always;
  const Json on_base{{"required", Json::array({BasedOn::kKey})}};
  (*schema)["anyOf"] = Json::array({on_base, by_itself});
}

}  // namespace

std::string ScenarioSchema() {
  const KeyInfo root = ScenarioKeys();
  Json schema{{"$schema", "https://json-schema.org/draft/2020-12/schema"},
              {"title", "Sidestep scenario"}};
  schema.update(SchemaOf(root));
  LeaveToBase(&schema);
  return schema.dump(2) + "\n";
}

}  // namespace sidestep
