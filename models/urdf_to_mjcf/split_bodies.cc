// SPDX-License-Identifier: BSD-3-Clause
#include "models/urdf_to_mjcf/split_bodies.h"

#include <algorithm>
#include <iterator>

#include "models/support/config_error.h"

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

void Split(const std::string& file, const UrdfForceTorque& sensor, Body* body) {
  const auto fail = [&](const std::string& what) {
    throw ConfigError(file + ": error: force/torque sensor '" + sensor.name + "': " + what);
  };
  const UrdfDistalPart& distal = *sensor.distal;
  if (!(distal.mass.mass_kg < body->mass.mass_kg)) {
    fail("its distal part weighs no less than the whole link '" + body->name + "'");
  }
  Body part;
  part.name = sensor.name + "_distal";
  part.mass = distal.mass;
  body->mass = Without(body->mass, part.mass);
  if (!IsPhysical(part.mass)) fail("its distal part has an inertia that no body has");
  if (!IsPhysical(body->mass))
    fail("it leaves link '" + body->name + "' an inertia that no body has");
  for (const std::string& joint : distal.joints) {
    const bool has_moved = MoveIf(&body->children, &part.children, [&](const Body& child) {
      return child.joint && child.joint->name == joint;
    });
    if (!has_moved) fail("link '" + body->name + "' has no joint '" + joint + "'");
  }
  for (const std::string& name : distal.shapes) {
    const bool has_moved =
        MoveIf(&body->shapes, &part.shapes, [&](const Shape& shape) { return shape.name == name; });
    if (!has_moved) fail("link '" + body->name + "' has no shape '" + name + "'");
  }
  MoveIf(&body->frames, &part.frames,
         [&](const Frame& frame) { return frame.name == sensor.name; });
  body->children.push_back(std::move(part));
}

}  // namespace

void SplitBodies(const std::string& file, const std::vector<UrdfForceTorque>& sensors, Body* base) {
  for (const UrdfForceTorque& sensor : sensors) {
    Body* body = FindCarrier(*base, sensor.name);
    if (body == nullptr) {
      throw ConfigError(file + ": error: force/torque sensor '" + sensor.name +
                        "' is no link without mass");
    }
    if (sensor.distal) {
      Split(file, sensor, body);
    } else if (body == base) {
      throw ConfigError(file + ": error: force/torque sensor '" + sensor.name +
                        "' is on the base and so has nothing on its other side");
    }
  }
}

}  // namespace sidestep
