// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// caption_colors: the boxes that words stand on, red, green and blue in 0..1; the words are white.
// They are the palette's, as on a light page.

#include <Eigen/Core>
#include <array>

#include "sim/palette/palette.h"

namespace sidestep::render {

inline Eigen::Vector3f BoxColor(const char* hex) {
  const std::array<float, 3> channels = palette::Channels(hex);
  return {channels[0], channels[1], channels[2]};
}

inline const Eigen::Vector3f kInk = BoxColor(palette::kInk.light);
inline const Eigen::Vector3f kPassGreen = BoxColor(palette::kPass.light);
inline const Eigen::Vector3f kFailRed = BoxColor(palette::kFail.light);
inline const Eigen::Vector3f kInvalidGrey = BoxColor(palette::kInvalid.light);
inline const Eigen::Vector3f kPushMagenta = BoxColor(palette::kPush);

}  // namespace sidestep::render
