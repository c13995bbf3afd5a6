// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// mjcf_sizes: whether an MJCF asks for more memory than a robot needs.
//
// A few attributes of MuJoCo's language are sizes: a line of text can ask for a texture of
// gigabytes (or one whose size no int holds), for a million bodies, or, by the number of its
// joints, for a stack of their square. MuJoCo takes what it is told, or ends the program.

#include <string>

namespace sidestep {

/// Joints of one file. MuJoCo's stack holds five squares of the degrees of freedom: of 800 free
/// joints it is 0.9 GB. A humanoid with fingers has a hundred.
inline constexpr int kMaxMjcfJoints = 800;

/// Throws ConfigError (`file:line:column: error: ...`) at the first element of `text` with a size
/// beyond its bound, or at the first joint beyond kMaxMjcfJoints. Says nothing of whether it is
/// good XML or MJCF.
void CheckMjcfSizes(const std::string& file, const std::string& text);

}  // namespace sidestep
