// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// json_node: strict reading of JSON, with errors that name the place.
//
// Every error is a ConfigError of one line: `$.contacts[1].phases[0].rotation: expected 9 finite
// numbers, got 8`. $ is the document's root.

#include <Eigen/Core>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <string>

namespace sidestep::mpc {

/// A value of a JSON document and its path. Refers to the document: must not outlive it.
class JsonNode {
 public:
  JsonNode(const nlohmann::json& value, std::string path);

  /// Throws ConfigError "<path>: expected <expectation>, got <what is there>".
  [[noreturn]] void Fail(const std::string& expectation) const;

  /// Throws unless this is an object that has every key of `required` and none outside both lists.
  void RequireKeys(std::initializer_list<const char*> required,
                   std::initializer_list<const char*> optional = {}) const;

  bool Has(const char* key) const { return value_.contains(key); }
  bool IsNull() const { return value_.is_null(); }
  JsonNode operator[](const char* key) const;
  JsonNode operator[](std::size_t index) const;
  std::size_t ArraySize() const;  ///< Throws if this is not an array.

  std::string String() const;
  bool Bool() const;
  int Integer(int minimum, int maximum) const;
  double Number() const;          ///< A finite number.
  double PositiveNumber() const;  ///< A finite number above zero.
  double NonNegativeNumber() const;
  Eigen::Vector3d Vector3() const;
  Eigen::Vector3d Weights3() const;  ///< Three numbers >= 0.
  /// Nine numbers, row-major: an orthonormal right-handed matrix (to 1e-6).
  Eigen::Matrix3d Rotation() const;
  Eigen::VectorXd Numbers(std::size_t size) const;
  /// `columns` rows of three numbers in the file, one a column here.
  Eigen::Matrix3Xd Columns3(std::size_t columns) const;

 private:
  const nlohmann::json& Array(std::size_t size, const char* of_what) const;

  const nlohmann::json& value_;
  std::string path_;
};

}  // namespace sidestep::mpc
