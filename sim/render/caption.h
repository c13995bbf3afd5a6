// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// caption: the words in a frame.

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "sim/record/run_reader.h"
#include "sim/record/run_summary.h"

namespace sidestep::render {

enum class CaptionPlace { kTopLeft, kTopRight, kBottom, kBottomLeft };

/// One line of text on a coloured box. Lines of one place are stacked downwards.
struct Caption {
  CaptionPlace place{CaptionPlace::kTopLeft};
  std::string text;  ///< Printable ASCII: MuJoCo's fonts know no more.
  Eigen::Vector3f background{Eigen::Vector3f::Zero()};
  bool is_big{false};
  std::optional<Eigen::Vector3f> swatch{};  ///< Colour of a square before the text.
};

/// The captions at row.time_s: the scenario's name and the time, what pushes where, the verdict.
/// In the last second before `end_s` the verdict is big and gives its reasons; of a robot that fell
/// as its scenario expected, that it fell is big.
/// @param speed  Of the film, told unless it is 1.
std::vector<Caption> CaptionsAt(const StateRow& row, double end_s, const RunSummary& summary,
                                double speed = 1.0);

/// What the colours of arrows and marks mean, at the bottom left; nothing in the last second,
/// which is the verdict's.
std::vector<Caption> LegendAt(const StateRow& row, double end_s, const RunSummary& summary,
                              const std::vector<std::string>& feet);

/// `text` with every byte that is no printable ASCII replaced by '?', cut to `max_length`.
std::string Printable(const std::string& text, std::size_t max_length);

}  // namespace sidestep::render
