// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// urdfdom_model: the only place that calls urdfdom, and what its types are in ours.

#include <urdf_model/model.h>

#include <Eigen/Geometry>
#include <memory>
#include <string>
#include <vector>

#include "models/urdf_to_mjcf/body_tree.h"
#include "models/urdf_to_mjcf/urdf_document.h"

namespace sidestep {

/// Throws ConfigError if urdfdom finds what CheckElements() and CheckGraph() did not.
std::shared_ptr<urdf::ModelInterface> ParseUrdf(const UrdfDocument& document,
                                                const std::string& file);

Eigen::Isometry3d FromUrdf(const urdf::Pose& pose);

/// Mass, CoM and inertia in the link's frame; zeros without any. Inertia may be impossible.
MassProperties MassOf(const urdf::Link& link);

/// Shapes of a link that is fixed to a body with the pose X_BL; visual ones first.
std::vector<Shape> ShapesOf(const urdf::Link& link, const Eigen::Isometry3d& X_BL,
                            const UrdfDocument& document);

}  // namespace sidestep
