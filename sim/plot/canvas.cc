// SPDX-License-Identifier: BSD-3-Clause
#include "sim/plot/canvas.h"

#include <cmath>
#include <regex>
#include <sstream>

#include "models/support/config_error.h"
#include "models/support/parse_number.h"

namespace sidestep::plot {
namespace {

constexpr double kPixelsAnInch = 96.0;
constexpr double kMillimetresAnInch = 25.4;
constexpr double kPointsAnInch = 72.0;
constexpr double kPaperFont_pt = 7.0;  // as journals ask of figures
constexpr double kPrintDpi = 300.0;
constexpr double kUsualHeight = 0.7;  // of the width
constexpr double kNarrowHeight =
    1.25;  // likewise: gnuplot drops legends that a panel is too low for
constexpr double kSmallScreen_px = 700;         // narrower, words shrink with the picture
constexpr double kSmallScreen_em = kNarrow_em;  // still no column
constexpr double kSmallest_mm = 30.0, kLargest_mm = 1000.0;
constexpr double kLineWidth = 1.3;  // of the terminal, at the usual font

[[noreturn]] void Refuse(const std::string& size) {
  throw ConfigError("sidestep: error: --size " + size + ": expected a size such as " + kSizeWords +
                    ", each side from 30 to 1000 mm");
}

// Of a text that is a number.
double SideOf(const std::string& text) { return ParseAs<double>(text).value_or(0.0); }

}  // namespace

Canvas ReadCanvas(const std::string& size) {
  static const std::regex kSize(R"((\d{1,5}(?:\.\d{1,3})?)(?:x(\d{1,5}(?:\.\d{1,3})?))?(mm|px))");
  std::smatch match;
  if (!std::regex_match(size, match, kSize)) Refuse(size);
  const bool is_paper = match[3] == "mm";
  const double unit_px = is_paper ? kPixelsAnInch / kMillimetresAnInch : 1.0;
  Canvas canvas;
  canvas.width_px = unit_px * SideOf(match[1]);
  canvas.font_px = is_paper ? kPaperFont_pt * kPixelsAnInch / kPointsAnInch
                   : canvas.width_px < kSmallScreen_px ? canvas.width_px / kSmallScreen_em
                                                       : canvas.font_px;
  canvas.height_px = match[2].matched
                         ? unit_px * SideOf(match[2])
                         : canvas.width_px * (canvas.is_narrow() ? kNarrowHeight : kUsualHeight);
  for (const double side_px : {canvas.width_px, canvas.height_px}) {
    const double side_mm = side_px * kMillimetresAnInch / kPixelsAnInch;
    if (side_mm < kSmallest_mm - 1e-9 || side_mm > kLargest_mm + 1e-9) Refuse(size);
  }
  canvas.png_scale = is_paper ? kPrintDpi / kPixelsAnInch : 1.0;
  canvas.is_fixed = true;
  canvas.suffix = "_" + size;
  return canvas;
}

std::string TerminalLines(const Canvas& canvas, const std::string& name) {
  const double font_pt = canvas.font_px * kPointsAnInch / kPixelsAnInch;
  const double line = kLineWidth * canvas.font_px / Canvas().font_px;
  std::ostringstream lines;
  lines << "if (!exists(\"format\")) format = \"svg\"\nif (format eq \"png\") {\n"
        << "  set terminal pngcairo size " << std::lround(canvas.width_px * canvas.png_scale) << ","
        << std::lround(canvas.height_px * canvas.png_scale) << " font \"DejaVu Sans,"
        << font_pt * canvas.png_scale << "\" noenhanced linewidth " << line * canvas.png_scale
        << " pointscale " << canvas.png_scale << "\n} else { if (format eq \"pdf\") {\n"
        << "  set terminal pdfcairo size " << canvas.width_px / kPixelsAnInch << "in,"
        << canvas.height_px / kPixelsAnInch << "in font \"DejaVu Sans," << font_pt
        << "\" fontscale 1 noenhanced linewidth " << line << " pointscale "
        << canvas.font_px / Canvas().font_px << "\n} else {\n  set terminal svg size "
        << canvas.width_px << "," << canvas.height_px << (canvas.is_fixed ? " fixed" : " dynamic")
        << " font \"DejaVu Sans," << canvas.font_px << "\" noenhanced linewidth " << line
        << "\n} }\nif (!exists(\"ending\")) ending = \"\"\nset output \"" << name
        << ".\".format.ending\n";
  return lines.str();
}

}  // namespace sidestep::plot
