// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// mjcf_text: numbers and attributes as MJCF text.

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <string>

namespace sidestep {

/// Shortest decimals that read back as the same doubles, with blanks between.
std::string Numbers(const double* values, Eigen::Index count);
std::string Numbers(const Eigen::VectorXd& values);
std::string Number(double value);

/// ` name="value"`, escaped.
std::string Attribute(const std::string& name, const std::string& value);

/// ` pos="..." quat="..."`.
std::string PoseAttributes(const Eigen::Isometry3d& X);

}  // namespace sidestep
