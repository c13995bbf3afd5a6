// SPDX-License-Identifier: BSD-3-Clause
#include "models/urdf_to_mjcf/body_tree.h"

#include <algorithm>

namespace sidestep {

Body* FindBody(Body& root, const std::string& name) {
  Body* found = nullptr;
  ForEachBody(root, [&](Body& body) {
    if (body.name == name) found = &body;
  });
  return found;
}

Body* FindCarrier(Body& root, const std::string& name) {
  Body* found = nullptr;
  ForEachBody(root, [&](Body& body) {
    const bool carries = std::any_of(body.frames.begin(), body.frames.end(),
                                     [&](const Frame& frame) { return frame.name == name; });
    if (carries) found = &body;
  });
  return found;
}

bool CarriesFrame(const Body& body, const std::vector<std::string>& frames) {
  const bool is_here = std::any_of(body.frames.begin(), body.frames.end(), [&](const Frame& frame) {
    return std::find(frames.begin(), frames.end(), frame.name) != frames.end();
  });
  return is_here || std::any_of(body.children.begin(), body.children.end(), [&](const Body& child) {
           return !child.joint && CarriesFrame(child, frames);
         });
}

}  // namespace sidestep
