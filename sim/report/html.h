// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// html: text to HTML, safely.

#include <string>
#include <string_view>
#include <vector>

namespace sidestep::report {

/// Text as it may stand in an element or a quoted attribute.
std::string Escaped(std::string_view text);

/// Bytes in base64 (RFC 4648), for data: addresses.
std::string Base64(std::string_view bytes);

/// A table. Cells are HTML already; the first column is the row's heading.
std::string Table(const std::vector<std::string>& headings,
                  const std::vector<std::vector<std::string>>& rows);

}  // namespace sidestep::report
