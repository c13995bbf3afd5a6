// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// mjcf_message: MuJoCo's complaint of an MJCF, with the place taken out of its words.

#include <string>

namespace sidestep {

struct MjcfMessage {
  std::string what;  ///< In one line.
  int line{0};       ///< From 1; 0 is unknown, as is the column.
  int column{0};
};

/// Its compiler says "line = 3, column = 7", its schema check "line 3, column 7", its XML parser
/// "Line number=3"; line 0 and column -1 mean unknown.
MjcfMessage ReadMjcfMessage(const std::string& message);

}  // namespace sidestep
