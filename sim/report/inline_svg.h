// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// inline_svg: makes a gnuplot SVG file part of an HTML page.

#include <string>

namespace sidestep::report {

/// The file's <svg> element without prologue and namespaces (HTML knows them), with every id
/// prefixed so that several plots share a page, and with black ink turned into the page's text
/// colour so that it is seen on a dark page. Empty if `svg` holds no <svg> element, or anything
/// that gnuplot does not draw with: scripts, links, animations, references to elsewhere.
/// @param prefix  Letters, digits and '-'; unique within the page.
/// @param label   What the picture shows, for readers who can't see it.
std::string InlineSvg(const std::string& svg, const std::string& prefix, const std::string& label);

}  // namespace sidestep::report
