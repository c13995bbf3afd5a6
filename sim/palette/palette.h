// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// palette: what a colour means, in plots, films, maps and pages alike.
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
inline constexpr const char* kGrid = "#B0B0B0";   ///< Of plots, on a light page and a dark one.

/// Of the i-th foot: its footholds, its forces, its stances.
constexpr const char* Foot(std::size_t foot) {
  constexpr std::array<const char*, 4> kFeet{"#0072B2", "#D55E00", "#56B4E9", "#E69F00"};
  return kFeet[foot % kFeet.size()];
}

/// Of x, y and z where all three are in one panel, all true.
constexpr const char* Axis(std::size_t axis) {
  constexpr std::array<const char*, 3> kAxes{"#0072B2", "#D55E00", "#56B4E9"};
  return kAxes[axis % kAxes.size()];
}

/// Of the first and second of two runs that are compared.
constexpr const char* Run(std::size_t run) {
  constexpr std::array<const char*, 2> kRuns{"#0072B2", "#D55E00"};
  return kRuns[run % kRuns.size()];
}

/// A colour on a light page, and the same in the dark.
struct Shades {
  const char* light;
  const char* dark;
};

inline constexpr Shades kGround{"#F5F6F8", "#14171B"};  ///< Of a page.
inline constexpr Shades kCard{"#FFFFFF", "#1D2126"};    ///< Of its cards and drawings.
inline constexpr Shades kInk{"#1B1F24", "#E8EAED"};     ///< Words.
inline constexpr Shades kSoftInk{"#5B6470", "#A2ABB5"};
inline constexpr Shades kRule{"#DDE1E6", "#343A41"};

// Grounds of verdicts, under white words.
inline constexpr Shades kPass{"#0B6E4F", "#187A59"};
inline constexpr Shades kFail{"#B3261E", "#C03D36"};
inline constexpr Shades kInvalid{"#5F6368", "#676D74"};

// Words about an expectation.
inline constexpr Shades kMet{"#0B6E4F", "#5FD3A9"};
inline constexpr Shades kMissed{"#B3261E", "#FF8A80"};

// Marks of a map.
inline constexpr Shades kMapGrid{"#D3D8DE", "#3D444C"};
inline constexpr Shades kRecovered{"#0072B2", "#56B4E9"};
inline constexpr Shades kLost{"#B84A00", "#FF9D5C"};
inline constexpr Shades kUndecided{"#5F6368", "#A2ABB5"};
inline constexpr Shades kPendulum{"#7A8A5C", "#9FB07C"};      ///< Its limit, an outline.
inline constexpr Shades kPendulumArea{"#EEF1E6", "#2A3026"};  ///< What that encloses.

// Ends of a map's scales: nothing or even, the most, and the most the other way.
inline constexpr const char* kScaleNone = "#F7F7F7";
inline constexpr const char* kScaleMost = "#084594";
inline constexpr const char* kScaleOpposite = "#A64400";

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
