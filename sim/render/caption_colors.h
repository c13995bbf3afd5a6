// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// caption_colors: the boxes that words stand on, red, green and blue in 0..1; the words are white.

#include <Eigen/Core>

namespace sidestep::render {

inline const Eigen::Vector3f kInk{0.10F, 0.11F, 0.13F};
inline const Eigen::Vector3f kPassGreen{0.05F, 0.45F, 0.30F};
inline const Eigen::Vector3f kFailRed{0.72F, 0.12F, 0.10F};
inline const Eigen::Vector3f kInvalidGrey{0.40F, 0.40F, 0.42F};
inline const Eigen::Vector3f kPushMagenta{0.80F, 0.00F, 0.40F};

}  // namespace sidestep::render
