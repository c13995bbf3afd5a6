// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// parse_xml: an XML text as TinyXML's elements, whose places are ours.

#include <tinyxml.h>

#include <string>

#include "models/support/text_place.h"

namespace sidestep {

/// Where an element begins.
inline TextPlace PlaceOf(const TiXmlBase& element) { return {element.Row(), element.Column()}; }

/// Parses `text`, within CheckXmlBounds(), into an empty document, its stray bytes replaced.
/// Throws ConfigError (`file:line:column: error: ...`) if it is no XML.
/// @param file  Its name, for messages.
void ParseXml(const std::string& file, const std::string& text, TiXmlDocument* document);

}  // namespace sidestep
