// SPDX-License-Identifier: BSD-3-Clause
#include "models/urdf_to_mjcf/parse_xml.h"

#include <algorithm>

#include "models/support/config_error.h"
#include "models/support/xml_bounds.h"

namespace sidestep {

void ParseXml(const std::string& file, const std::string& text, TiXmlDocument* document) {
  document->SetTabSize(1);  // columns count bytes
  document->Parse(WithoutStrayBytes(text).c_str(), nullptr, TIXML_ENCODING_UTF8);
  if (!document->Error()) return;
  throw ConfigError(file, std::max(document->ErrorRow(), 1), std::max(document->ErrorCol(), 1),
                    document->ErrorDesc());
}

}  // namespace sidestep
