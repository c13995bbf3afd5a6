// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// film_graph: ffmpeg's filter graphs for two runs side by side, and for a strip of their pictures.
//
// Pure functions of sizes and times. Words never stand in a graph, where quotes, colons and commas
// have meanings: they are read from files with names of our making, in ffmpeg's working folder.

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "sim/render/outcome.h"
#include "sim/render/video_probe.h"

namespace sidestep::render {

/// Words as they fit into a width.
struct FittedText {
  std::string text;  ///< One line; cut with ".." if even the smallest letters are too wide.
  int font_px{0};
};

/// Sets `text`, UTF-8, as large as fits: between half of `largest_px` and that. What is no
/// printable character becomes a space. Widths are estimates on the safe side (DejaVu Sans).
FittedText FitText(const std::string& text, int width_px, int largest_px);

/// What stands over one run.
struct Heading {
  std::string label;
  Outcome outcome;
};

/// A graph, and the text files that it reads: {name, contents}.
struct FilterGraph {
  std::string graph;
  std::vector<std::pair<std::string, std::string>> text_files;
};

/// A film's measures.
struct FilmLayout {
  std::array<int, 2> width_px{};  ///< Of each half's picture; even.
  int height_px{0};               ///< Of both; even: the larger one of the two videos.
  int bar_px{0};                  ///< Height of the bar above them; even.
  int gap_px{0};                  ///< Between the halves; even.
  std::string rate;               ///< Frames a second: the faster one of the two.
  int frames{0};                  ///< As many as last as long as the longer video.
};

FilmLayout LayOutFilm(const std::array<VideoInfo, 2>& videos);

/// The graph of inputs 0 and 1, left and right, to [out]: both begin together, and the one that is
/// over first stands still. It never ends: cut it after layout.frames.
FilterGraph FilmGraph(const FilmLayout& layout, const std::array<Heading, 2>& headings);

/// A strip's measures: a row a run, a column a time.
struct StripLayout {
  int cell_px{0};         ///< Side of a picture, which is square; even.
  int drawn_width_px{0};  ///< Of the pictures as drawn, before their sides are cut off; even.
  int bar_px{0};          ///< Height of the heading above a row.
};

/// Pictures as large as go into the README's width, 1400, but at most 350 high.
StripLayout LayOutStrip(std::size_t columns);

/// The graph of inputs 0..2n-1, first run's pictures first, to [out].
FilterGraph StripGraph(const StripLayout& layout, const std::vector<double>& times_s,
                       const std::array<Heading, 2>& headings);

}  // namespace sidestep::render
