// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// plot_script: gnuplot scripts as text. Pure functions; plot_run.cc runs them.
//
// Colours are Okabe and Ito's, which colour-blind people can tell apart; black is kept for text,
// so that a report may recolour it on a dark page. Legends stand below the panels, never on data.

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "sim/plot/plot_data.h"

namespace sidestep::plot {

inline constexpr const char* kTruthColor = "#0072B2";
inline constexpr const char* kReferenceColor = "#E69F00";
inline constexpr const char* kMpcColor = "#009E73";
inline constexpr const char* kNominalColor = "#808080";
inline constexpr const char* kPushColor = "#CC0066";

inline constexpr std::array<const char*, 3> kAxes{"x", "y", "z"};

/// Colour of the i-th foot.
std::string FootColor(std::size_t foot);

struct PlotScript {
  std::string name;  ///< Of its files.
  std::function<std::string(const PlotData&)> body;
};

/// All plots, in the order a report shows them.
std::vector<PlotScript> AllScripts();

/// Terminal, output file, number format and line styles that every script starts with.
std::string Preamble(const std::string& name);

/// Starts a page of rows x columns panels over the run's time, with pushes shaded.
std::string StartPanels(const PlotData& data, const std::string& title, int rows, int columns);

/// One line of a thinned column over time: `'' using "time_s":"column" with lines ...`.
std::string Curve(const std::string& column, const std::string& style, const std::string& title);

/// A line's colour and, in gnuplot's words, `more` of its style.
std::string LineStyle(const std::string& color, const std::string& more = "linewidth 1.6");

/// A legend entry for the shaded push windows, or nothing without pushes. Ends in no comma.
std::string PushKey(const PlotData& data);

// motion_scripts.cc
std::string ComScript(const PlotData& data);       ///< Position and velocity, reference and MPC.
std::string MomentumScript(const PlotData& data);  ///< Push, angular momentum, tilt.
std::string SolveScript(const PlotData& data);     ///< MPC time and iterations, with deadline.

// contact_scripts.cc
std::string TopViewScript(const PlotData& data);
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
