// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// mjcf_frames: a body in <frame>s of the world, without them.
//
// A frame in a body can become a body without a name, welded. One in the world can't: a body on a
// <freejoint> must be the world's own child.

#include <string>
#include <vector>

#include "models/import/xml_tree.h"

namespace sidestep::importer {

/// Gives the body the pose that it has in the world and, if it has none of its own, the innermost
/// childclass. Returns what MuJoCo can't read of the poses; empty if all is well.
/// @param frames    Inside each other, the outermost first.
/// @param compiler  The document's, for angles and Euler sequences.
std::string PutIntoFrames(const std::vector<const XmlElement*>& frames, const XmlElement& compiler,
                          XmlElement* body);

}  // namespace sidestep::importer
