// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// plain_line: words from anywhere as one line for a person at a terminal.
//
// Messages quote files, and a file may hold anything: an escape that recolours the terminal, a line
// end that begins another message, a value of a megabyte.

#include <cstddef>
#include <string>

namespace sidestep {

inline constexpr std::size_t kLongestLine = 1800;  ///< Bytes; of more, both ends are kept.

/// `text` with a blank for every line end, a '?' for every other control character and every byte
/// that is no UTF-8, and its middle left out if it is longer than kLongestLine.
std::string PlainLine(std::string text);

}  // namespace sidestep
