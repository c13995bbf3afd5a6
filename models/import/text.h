// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// text: numbers and names as a person reads them.

#include <string>
#include <vector>

namespace sidestep::importer {

/// `value` with at most `digits` significant digits, without trailing zeros: 0.25, 12000.
std::string Figure(double value, int digits = 4);

/// `value` rounded to `digits` significant digits.
double Rounded(double value, int digits = 3);

/// "a, b and c"; of many names the first four and how many more.
std::string Listed(const std::vector<std::string>& names);

/// `text` with what XML reserves escaped.
std::string XmlEscaped(const std::string& text);

}  // namespace sidestep::importer
