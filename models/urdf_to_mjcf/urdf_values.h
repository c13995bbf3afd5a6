// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// urdf_values: numbers, origins and shapes in a URDF's elements, and what is wrong with them.
//
// Faults follow "link 'x' " or "joint 'x' " in a message, and are empty where there is none.

#include <tinyxml.h>

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "models/urdf_to_mjcf/urdf_document.h"

namespace sidestep {

/// The number that is the whole of `text`, but NaN and infinities.
std::optional<double> FiniteNumber(std::string_view text);

// Bounds of what numbers may mean; beyond, they have another unit or are placeholders.
inline constexpr double kMaxUrdfLength_m = 10.0;  ///< Catches millimetres.
inline constexpr double kMaxUrdfAngle_rad = 1e3;
inline constexpr double kMaxUrdfMass_kg = 1e4;
inline constexpr double kMaxUrdfInertia_kgm2 = 1e6;  ///< Of the greatest mass and length.
inline constexpr double kMaxUrdfNumber = 1e20;       ///< Of what is bounded elsewhere.

/// Why `attribute` does not hold `count` numbers of at most this size; not being there is no fault.
/// Blanks of all kinds between the numbers become single ones, which is all that urdfdom takes.
std::string FaultOfNumbers(TiXmlElement* element, const char* attribute, std::size_t count,
                           double most);

/// The same of an <origin> within `parent`.
std::string FaultOfOrigin(TiXmlElement* parent);

/// The same of origin and shape of `owner`, a <visual> or <collision>. A capsule, which urdfdom
/// does not know, becomes the cylinder that urdf_to_mjcf makes that capsule of.
std::string FaultOfShape(TiXmlElement* owner);

}  // namespace sidestep
