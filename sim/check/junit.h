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

/// Where and when a check ran.
struct CheckPlace {
  std::string timestamp;  ///< ISO 8601, without a zone: UTC.
  std::string hostname;
};

/// This machine, now.
CheckPlace ThisPlace();

/// A JUnit document, with only what Jenkins' xUnit schema (junit-10.xsd) and GitLab both take: one
/// suite, one case a scenario with its time, its robot as class; a FAIL is a <failure> and an
/// INVALID an <error> with its reasons. `system-out` tells files, measured values and, as
/// `[[ATTACHMENT|path]]`, what the run left to look at.
std::string JunitXml(const std::vector<Outcome>& outcomes, double wall_s, const CheckPlace& place);

}  // namespace sidestep
