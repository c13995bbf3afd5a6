// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// hash_text: a short name for a text, to tell it from others; no defence against forgers.

#include <string>
#include <string_view>

namespace sidestep {

/// 64 bits as 16 hexadecimal digits: FNV-1a (Fowler, Noll, Vo), with its 64-bit basis and prime.
std::string HashText(std::string_view text);

}  // namespace sidestep
