// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// plot_script: gnuplot scripts as text. Pure functions; plot_run.cc runs them.
//
// Colours are the palette's; black is kept for text and plans, so that a report may recolour it on
// a dark page. What is true is drawn first and thick, what is believed, planned or to be followed
// thin on top of it: where they agree, both are seen. Legends stand below the panels, never on
// data. Axes hold all that is drawn.

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "sim/plot/plot_data.h"

namespace sidestep::plot {

inline constexpr std::array<const char*, 3> kAxes{"x", "y", "z"};

// gnuplot's words for lines.
inline constexpr const char* kThick = "linewidth 3.2";
inline constexpr const char* kThin = "linewidth 1.3";
inline constexpr const char* kDashed = "linewidth 1.1 dashtype (6,3)";

struct PlotScript {
  std::string name;  ///< Of its files.
  std::function<std::string(const PlotData&)> body;
};

/// All plots, in the order a report shows them.
const std::vector<PlotScript>& AllScripts();

/// A whole script: terminal, number format and line styles, then the rest.
/// @param name         Of its files, without extension.
/// @param definitions  Of the curves that `body` draws (CurveFile::Definitions).
std::string ScriptText(const Canvas& canvas, const std::string& name,
                       const std::string& definitions, const std::string& body);

/// A number as scripts have it, to six digits.
std::string Number(double value);

/// The next of 1, 2 and 5 times a power of ten.
double NiceStep(double step);

/// `what` after the run's name and verdict, or alone where that is too long for the canvas.
std::string TitleText(const PlotData& data, const std::string& what);

/// Where the panels of a page are, in ems: left, right, bottom and top edge, and between them.
struct Margins {
  double left{7.0}, right{1.8}, bottom{0.0}, top{4.2}, between_columns{8.5};
};
Margins MarginsOf(const Canvas& canvas);

/// Between rows of panels, for the numbers below them; and where each panel has its labels.
inline constexpr double kBetweenRows_em = 3.4;
inline constexpr double kBetweenLabelledRows_em = 7.0;

/// Width and height of one of rows x columns panels, in ems; at least 1.
Eigen::Vector2d PanelSize_em(const Canvas& canvas, int rows, int columns,
                             double between_rows_em = kBetweenRows_em);

/// `set multiplot` of rows x columns panels; `title` is quoted here.
std::string StartMultiplot(const PlotData& data, const std::string& title, int rows, int columns,
                           double between_rows_em = kBetweenRows_em);

/// The same, over the run's time, with pushes shaded.
std::string StartPanels(const PlotData& data, const std::string& title, int rows, int columns);

/// Between tics of time, so that their numbers have room on a panel of that length.
double TimeStep_s(double duration_s, double length_em);

/// Range and tics of an axis, "x" or "y", that holds `span` on a panel of that length. What hardly
/// moves, by its own size, is shown as standing still: in tics' six digits its motion has no room.
std::string AxisLines(const std::string& axis, Span span, double length_em);

/// AxisLines of y for a panel of `rows` that draws these curves and perhaps zero.
std::string YAxis(const PlotData& data, int rows, const std::vector<std::string>& curves,
                  bool has_zero = false);

/// A curve as lines: `@column with lines ...`.
std::string Curve(const PlotData& data, const std::string& name, const std::string& style,
                  const std::string& title);

/// A line's colour and, in gnuplot's words, `more` of its style.
std::string LineStyle(const std::string& color, const std::string& more = kThin);

/// The same, half transparent: what is true of a foot, below what was planned for it.
std::string FaintStyle(const std::string& color, const std::string& more = kThick);

/// A thin grey line at zero.
std::string ZeroLine();

/// A legend entry for the shaded push windows, or nothing without pushes. Ends in no comma.
std::string PushKey(const PlotData& data);

/// `$name << END ... END`: rows of numbers; a single row of NaN if there are none, as gnuplot
/// takes an empty table for an error.
std::string DataBlock(const std::string& name, const std::string& rows, int columns);

// motion_scripts.cc
std::string ComScript(const PlotData& data);       ///< Position and velocity, reference and MPC.
std::string MomentumScript(const PlotData& data);  ///< Push, angular momentum, tilt.
std::string SolveScript(const PlotData& data);     ///< MPC time and iterations, with deadline.

// top_view_script.cc
std::string TopViewScript(const PlotData& data);

// contact_scripts.cc
std::string ContactForceScript(const PlotData& data);
std::string AdjustmentScript(const PlotData& data);

// body_scripts.cc
std::string ExternalWrenchScript(const PlotData& data);  ///< The push, true and believed.
std::string FeetScript(const PlotData& data);            ///< Heights and centres of pressure.

// gait_scripts.cc
std::string GaitScript(const PlotData& data);  ///< When each foot stood, and was to.

// phase_scripts.cc
std::string PhasePortraitScript(const PlotData& data);  ///< CoM and base against their rates.

}  // namespace sidestep::plot
