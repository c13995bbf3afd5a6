// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// mjcf_sizes: whether an MJCF asks for more memory than a robot needs.
//
// A few attributes of MuJoCo's language are sizes: a line of text can ask for a texture of
// gigabytes (or one whose size no int holds), for a million bodies, or, by the number of its
// joints, for a stack of their square. MuJoCo takes what it is told, or ends the program.

#include "models/support/xml_tags.h"

namespace sidestep {

/// Joints of an MJCF with what it includes. MuJoCo's stack holds five squares of the degrees of
/// freedom: of 800 free joints it is 0.9 GB. A humanoid with fingers has a hundred.
inline constexpr int kMaxMjcfJoints = 800;

/// Looks at the tags of an MJCF and of the files that it includes, one by one.
class MjcfSizes {
 public:
  /// Throws ConfigError (`file:line:column: error: ...`) at a tag with a size beyond its bound, and
  /// at the first joint beyond kMaxMjcfJoints.
  /// @param tags  Where `tag` is from.
  void Check(const XmlTags& tags, const XmlTag& tag);

 private:
  int num_joints_{0};
};

}  // namespace sidestep
