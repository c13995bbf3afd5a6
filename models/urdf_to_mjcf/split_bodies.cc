// SPDX-License-Identifier: BSD-3-Clause
#include "models/urdf_to_mjcf/split_bodies.h"

#include <algorithm>
#include <iterator>

#include "models/support/require.h"

namespace sidestep {
namespace {

/// Moves the elements of `from` that `is_moved` to the end of `to`; returns whether there were any.
template <typename T, typename Predicate>
bool MoveIf(std::vector<T>* from, std::vector<T>* to, Predicate&& is_moved) {
  const auto moved = std::stable_partition(from->begin(), from->end(),
                                           [&](const T& element) { return !is_moved(element); });
  const bool has_moved = moved != from->end();
  std::move(moved, from->end(), std::back_inserter(*to));
  from->erase(moved, from->end());
  return has_moved;
}

void Split(const UrdfForceTorque& sensor, Body* body) {
  const UrdfDistalPart& distal = *sensor.distal;
  Body part;
  part.name = sensor.name + "_distal";
  part.mass = distal.mass;
  body->mass = Without(body->mass, part.mass);
  SIDESTEP_REQUIRE(IsPhysical(part.mass), sensor.name);
  SIDESTEP_REQUIRE(IsPhysical(body->mass), sensor.name);
  for (const std::string& joint : distal.joints) {
    const bool has_moved = MoveIf(&body->children, &part.children, [&](const Body& child) {
      return child.joint && child.joint->name == joint;
    });
    SIDESTEP_REQUIRE(has_moved, joint);
  }
  for (const std::string& name : distal.shapes) {
    const bool has_moved =
        MoveIf(&body->shapes, &part.shapes, [&](const Shape& shape) { return shape.name == name; });
    SIDESTEP_REQUIRE(has_moved, name);
  }
  MoveIf(&body->frames, &part.frames,
         [&](const Frame& frame) { return frame.name == sensor.name; });
  body->children.push_back(std::move(part));
}

}  // namespace

void SplitBodies(const std::vector<UrdfForceTorque>& sensors, Body* base) {
  for (const UrdfForceTorque& sensor : sensors) {
    Body* body = FindCarrier(*base, sensor.name);
    SIDESTEP_REQUIRE(body != nullptr, sensor.name);
    SIDESTEP_REQUIRE(sensor.distal || body != base, sensor.name);
    if (sensor.distal) Split(sensor, body);
  }
}

}  // namespace sidestep
