// SPDX-License-Identifier: BSD-3-Clause
#include "models/support/hash_text.h"

#include <cstdint>
#include <cstdio>

namespace sidestep {

std::string HashText(std::string_view text) {
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (const char letter : text) {
    hash ^= static_cast<unsigned char>(letter);
    hash *= 0x100000001b3U;
  }
  char digits[17];
  std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(hash));
  return digits;
}

}  // namespace sidestep
