// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// canvas: how large a plot is, how large its words are, and gnuplot's terminals for it.
//
// Everything is laid out in ems, the size of its words, so that a column of a paper has the same
// margins around fewer numbers.

#include <string>

namespace sidestep::plot {

/// Ems across, below which there is room for less: a paper's column has 36.
inline constexpr double kNarrow_em = 50.0;

/// A plot's size. Pixels are those of CSS and SVG, 96 an inch.
struct Canvas {
  double width_px{1000.0};
  double height_px{700.0};
  double font_px{14.0};
  double png_scale{1.0};  ///< Pixels of a PNG a pixel; 300 dpi for what is told in millimetres.
  bool is_fixed{false};   ///< An SVG keeps this size; else it fills the page that it is on.
  std::string suffix;     ///< Of its files' names, `_88mm`; empty for the usual size.

  double width_em() const { return width_px / font_px; }
  double height_em() const { return height_px / font_px; }

  /// Narrower than that by more than rounding, for small screens have just as many ems.
  bool is_narrow() const { return width_em() < kNarrow_em - 1e-6; }
};

/// What --size takes.
inline constexpr const char* kSizeWords = "88mm, 160x100mm, 800px or 800x600px";

/// Reads a size: a width with or without a height, in mm (words of 7 points) or px. Without one,
/// the height is 0.7 of the width, or 1.25 of it where that is narrow.
/// @throws ConfigError in a line if it is none, or is below 30 mm or above 1000 mm.
Canvas ReadCanvas(const std::string& size);

/// The lines of a script that choose terminal and output: svg unless gnuplot was told
/// `-e "format='png'"` or `'pdf'`.
/// @param name  Of the plot's files, without extension.
std::string TerminalLines(const Canvas& canvas, const std::string& name);

}  // namespace sidestep::plot
