// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// utf8: which bytes of a text are characters.

#include <cstddef>
#include <string>

namespace sidestep {

/// Bytes of the UTF-8 sequence at `text[at]`, 0 if it is none. Overlong forms, surrogates and
/// values above U+10FFFF are none (RFC 3629).
std::size_t Utf8Length(const std::string& text, std::size_t at);

}  // namespace sidestep
