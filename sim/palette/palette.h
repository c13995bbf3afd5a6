// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// palette: what a colour means, in plots and in films alike.
//
// Okabe and Ito's colours, which colour-blind people can tell apart; magenta is kept for pushes.
// As #RRGGBB, which gnuplot and HTML read.

#include <array>
#include <cstddef>

namespace sidestep::palette {

inline constexpr const char* kTruth = "#009E73";      ///< The CoM, and what else is true.
inline constexpr const char* kReference = "#E69F00";  ///< What is to be followed.
inline constexpr const char* kBelief = "#CC79A7";     ///< What the estimator takes it to be.
inline constexpr const char* kPlanned = "#000000";    ///< The MPC's plan; a page's ink.
inline constexpr const char* kNominal = "#6B7280";    ///< Footholds as the gait has them.
inline constexpr const char* kPush = "#CC0066";
inline constexpr const char* kLimit = "#D55E00";  ///< A deadline.

/// Of the i-th foot: its footholds, its forces, its stances.
constexpr const char* Foot(std::size_t foot) {
  constexpr std::array<const char*, 4> kFeet{"#0072B2", "#D55E00", "#56B4E9", "#E69F00"};
  return kFeet[foot % kFeet.size()];
}

/// Red, green and blue of `hex` in 0..1. Precondition: `hex` is #RRGGBB in capitals.
constexpr std::array<float, 3> Channels(const char* hex) {
  const auto digit = [](char c) { return c <= '9' ? c - '0' : c - 'A' + 10; };
  std::array<float, 3> channels{};
  for (std::size_t i = 0; i < channels.size(); ++i) {
    const int byte = 16 * digit(hex[1 + 2 * i]) + digit(hex[2 + 2 * i]);
    channels[i] = static_cast<float>(byte) / 255.0F;
  }
  return channels;
}

}  // namespace sidestep::palette
