// SPDX-License-Identifier: BSD-3-Clause
#include "controller/mpc/problem/json_node.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "models/support/config_error.h"

namespace sidestep::mpc {
namespace {

constexpr double kRotationTolerance = 1e-6;  // Files carry about twelve digits.

std::string Describe(const nlohmann::json& value) {
  if (value.is_object()) {
    return "an object";
  }
  if (value.is_array()) {
    return "an array of " + std::to_string(value.size());
  }
  // Replaces bytes that are not UTF-8 instead of throwing.
  return value.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
}

bool Contains(std::initializer_list<const char*> keys, const std::string& key) {
  return std::any_of(keys.begin(), keys.end(), [&](const char* other) { return key == other; });
}

}  // namespace

JsonNode::JsonNode(const nlohmann::json& value, std::string path)
    : value_(value), path_(std::move(path)) {}

void JsonNode::Fail(const std::string& expectation) const {
  throw ConfigError(path_ + ": expected " + expectation + ", got " + Describe(value_));
}

void JsonNode::RequireKeys(std::initializer_list<const char*> required,
                           std::initializer_list<const char*> optional) const {
  if (!value_.is_object()) {
    Fail("an object");
  }
  for (const char* key : required) {
    if (!value_.contains(key)) {
      throw ConfigError(path_ + ": expected the key \"" + key + "\", which is missing");
    }
  }
  for (const auto& item : value_.items()) {
    if (!Contains(required, item.key()) && !Contains(optional, item.key())) {
      throw ConfigError(path_ + ": unknown key " + Describe(item.key()));
    }
  }
}

JsonNode JsonNode::operator[](const char* key) const { return {value_.at(key), path_ + "." + key}; }

JsonNode JsonNode::operator[](std::size_t index) const {
  return {value_.at(index), path_ + "[" + std::to_string(index) + "]"};
}

std::size_t JsonNode::ArraySize() const {
  if (!value_.is_array()) {
    Fail("an array");
  }
  return value_.size();
}

const nlohmann::json& JsonNode::Array(std::size_t size, const char* of_what) const {
  if (!value_.is_array() || value_.size() != size) {
    Fail("an array of " + std::to_string(size) + " " + of_what);
  }
  return value_;
}

std::string JsonNode::String() const {
  if (!value_.is_string()) {
    Fail("a string");
  }
  return value_.get<std::string>();
}

bool JsonNode::Bool() const {
  if (!value_.is_boolean()) {
    Fail("true or false");
  }
  return value_.get<bool>();
}

int JsonNode::Integer(int minimum, int maximum) const {
  const bool in_range = value_.is_number_integer() &&
                        !(value_.is_number_unsigned() &&
                          value_.get<std::uint64_t>() > static_cast<std::uint64_t>(INT32_MAX)) &&
                        value_.get<std::int64_t>() >= minimum &&
                        value_.get<std::int64_t>() <= maximum;
  if (!in_range) {
    Fail("an integer from " + std::to_string(minimum) + " to " + std::to_string(maximum));
  }
  return value_.get<int>();
}

double JsonNode::Number() const {
  if (!value_.is_number() || !std::isfinite(value_.get<double>())) {
    Fail("a finite number");
  }
  return value_.get<double>();
}

double JsonNode::PositiveNumber() const {
  if (!value_.is_number() || !std::isfinite(value_.get<double>()) ||
      !(value_.get<double>() > 0.0)) {
    Fail("a finite number above zero");
  }
  return value_.get<double>();
}

double JsonNode::NonNegativeNumber() const {
  const double number = Number();
  if (number < 0.0) Fail("a number of at least 0");
  return number;
}

Eigen::VectorXd JsonNode::Numbers(std::size_t size) const {
  Array(size, "numbers");
  Eigen::VectorXd numbers(static_cast<Eigen::Index>(size));
  for (std::size_t i = 0; i < size; ++i) {
    numbers(static_cast<Eigen::Index>(i)) = (*this)[i].Number();
  }
  return numbers;
}

Eigen::Vector3d JsonNode::Vector3() const { return Numbers(3); }

Eigen::Vector3d JsonNode::Weights3() const {
  Eigen::Vector3d weights = Vector3();
  if (weights.minCoeff() < 0.0) {
    Fail("three numbers >= 0");
  }
  return weights;
}

Eigen::Matrix3d JsonNode::Rotation() const {
  const Eigen::VectorXd numbers = Numbers(9);
  Eigen::Matrix3d rotation;
  rotation << numbers(0), numbers(1), numbers(2), numbers(3), numbers(4), numbers(5), numbers(6),
      numbers(7), numbers(8);
  const double error =
      (rotation.transpose() * rotation - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
  if (!(error < kRotationTolerance) || rotation.determinant() < 0.0) {
    Fail("an orthonormal, right-handed matrix");
  }
  return rotation;
}

Eigen::Matrix3Xd JsonNode::Columns3(std::size_t columns) const {
  Array(columns, "rows of 3 numbers");
  Eigen::Matrix3Xd result(3, static_cast<Eigen::Index>(columns));
  for (std::size_t k = 0; k < columns; ++k) {
    result.col(static_cast<Eigen::Index>(k)) = (*this)[k].Vector3();
  }
  return result;
}

}  // namespace sidestep::mpc
