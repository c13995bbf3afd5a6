// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// junit: the report that CI servers read.

#include <string>
#include <string_view>
#include <vector>

#include "sim/check/outcome.h"

namespace sidestep {

/// `text` for an XML 1.0 attribute or element: markup is escaped; characters that XML forbids and
/// bytes that are no UTF-8 are dropped. Line ends and tabs stay (as references, so that they also
/// survive in an attribute).
std::string XmlEscape(std::string_view text);

/// A JUnit document: one suite, one case a scenario with its time; a FAIL is a <failure> and an
/// INVALID an <error>, each with its reasons and measured values.
std::string JunitXml(const std::vector<Outcome>& outcomes, double wall_s);

}  // namespace sidestep
