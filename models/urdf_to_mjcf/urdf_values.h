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

/// Why `attribute` does not hold `count` finite numbers; not being there is no fault. Blanks of all
/// kinds between the numbers become single ones, which is all that urdfdom takes.
std::string FaultOfNumbers(TiXmlElement* element, const char* attribute, std::size_t count);

/// The same of an <origin> within `parent`.
std::string FaultOfOrigin(TiXmlElement* parent);

/// The same of origin and shape of `owner`, a <visual> or <collision>. A capsule, which urdfdom
/// does not know, becomes the cylinder that urdf_to_mjcf makes that capsule of.
std::string FaultOfShape(TiXmlElement* owner);

}  // namespace sidestep
