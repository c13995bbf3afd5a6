// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// room_table: which room may include which. The architecture, as the layering test holds it.

#include <vector>

#include "tests/layering/include_rules.h"

namespace sidestep::layering {

/// Every room of models/, controller/ and sim/.
std::vector<Room> Rooms();

}  // namespace sidestep::layering
