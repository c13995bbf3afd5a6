// SPDX-License-Identifier: BSD-3-Clause
#include "sim/render/film_graph.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "models/support/require.h"
#include "sim/record/output_file.h"
#include "sim/render/caption_colors.h"

namespace sidestep::render {
namespace {

// Advance of a letter over the font's size. DejaVu Sans is wide: its mean over English is 0.57.
constexpr double kLatinAdvance = 0.62;
constexpr double kOtherAdvance = 1.0;  // CJK letters are square

// Shares of a film's height.
constexpr double kBarShare = 1.0 / 6.0;
constexpr double kLabelShare = 1.0 / 17.0;
constexpr double kOutcomeShare = 1.0 / 20.0;

constexpr int kStripWidth_px = 1400;
constexpr int kLargestCell_px = 350;
constexpr int kStripBar_px = 38;
constexpr int kStripFont_px = 22;
constexpr int kTimeFont_px = 18;

int Even(double length_px) { return 2 * static_cast<int>(std::lround(0.5 * length_px)); }

bool StartsLetter(char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }

double Advance(const std::string& text) {
  double sum = 0.0;
  for (const char c : text) {
    if (StartsLetter(c))
      sum += static_cast<unsigned char>(c) < 0x80U ? kLatinAdvance : kOtherAdvance;
  }
  return sum;
}

std::string Number(double value) {
  std::string text;
  AppendNumber(text, value);
  return text;
}

std::string Pixels(int length_px) { return std::to_string(length_px); }

std::string Hex(const Eigen::Vector3f& color) {
  char text[16];
  const auto byte = [&](int i) { return static_cast<unsigned>(std::lround(255.0F * color[i])); };
  std::snprintf(text, sizeof text, "0x%02x%02x%02x", byte(0), byte(1), byte(2));
  return text;
}

// Where a line of words stands: `x` may use w (the picture's width) and tw (the words').
struct TextPlace {
  std::string x;
  int baseline_px{0};
  double from_s{0.0};
  bool is_boxed{false};  // on a dark box: for words on a picture
};

// The filter that writes `text`, with its comma in front; empty for no words.
std::string Write(const FittedText& text, const TextPlace& place, FilterGraph* graph) {
  if (text.text.empty()) return "";
  const std::string file = "text" + std::to_string(graph->text_files.size()) + ".txt";
  graph->text_files.emplace_back(file, text.text);
  return ",drawtext=textfile=" + file +
         ":expansion=none:font=Sans:fontcolor=white:fontsize=" + Pixels(text.font_px) +
         ":x=" + place.x + ":y=" + Pixels(place.baseline_px) + "-ascent:enable='gte(t," +
         Number(place.from_s) + ")'" +
         (place.is_boxed ? ":box=1:boxborderw=5:boxcolor=" + Hex(kInk) : "");
}

std::string Box(int width_px, int height_px, const Eigen::Vector3f& color, double from_s) {
  return ",drawbox=x=0:y=0:w=" + Pixels(width_px) + ":h=" + Pixels(height_px) +
         ":t=fill:color=" + Hex(color) + ":enable='gte(t," + Number(from_s) + ")'";
}

std::string Half(const FilmLayout& layout, int side, const Heading& heading, FilterGraph* graph) {
  const int width_px = layout.width_px[static_cast<std::size_t>(side)];
  const int gap_px = side == 0 ? layout.gap_px : 0;
  const auto font_px = [&](double share) { return static_cast<int>(layout.height_px * share); };
  const int words_px = width_px - 2 * font_px(kLabelShare);
  const std::string middle = "(" + Pixels(width_px) + "-tw)/2";
  const auto baseline_px = [&](double share) { return static_cast<int>(layout.bar_px * share); };
  std::string filters = "[" + std::to_string(side) + ":v]fps=" + layout.rate +
                        ",scale=" + Pixels(width_px) + ":" + Pixels(layout.height_px) +
                        ",setsar=1,tpad=stop=-1:stop_mode=clone,pad=" + Pixels(width_px + gap_px) +
                        ":" + Pixels(layout.height_px + layout.bar_px) +
                        ":0:" + Pixels(layout.bar_px) + ":color=" + Hex(kInk);
  filters += Box(width_px, layout.bar_px, heading.outcome.color, heading.outcome.from_s);
  filters += Write(FitText(heading.label, words_px, font_px(kLabelShare)),
                   {middle, baseline_px(0.44), 0.0}, graph);
  filters += Write(FitText(heading.outcome.text, words_px, font_px(kOutcomeShare)),
                   {middle, baseline_px(0.84), heading.outcome.from_s}, graph);
  return filters + "[half" + std::to_string(side) + "];";
}

// One run's pictures side by side under its heading.
std::string StripRow(const StripLayout& layout, const std::vector<double>& times_s, int row,
                     const Heading& heading, FilterGraph* graph) {
  const std::string cell = Pixels(layout.cell_px);
  std::string filters, cells;
  for (std::size_t i = 0; i < times_s.size(); ++i) {
    const std::size_t input = static_cast<std::size_t>(row) * times_s.size() + i;
    char time[32];
    std::snprintf(time, sizeof time, "%.2f s", times_s[i]);
    const std::string name = "[cell" + std::to_string(input) + "]";
    filters +=
        "[" + std::to_string(input) + ":v]crop=" + cell + ":" + cell + ",setsar=1" +
        Write(FitText(time, layout.cell_px, kTimeFont_px),
              {"w-tw-" + Pixels(kTimeFont_px / 2), layout.cell_px - kTimeFont_px / 2, 0.0, true},
              graph) +
        name + ";";
    cells += name;
  }
  const bool is_single = times_s.size() == 1;
  filters += cells + (is_single ? "null" : "hstack=" + std::to_string(times_s.size()));
  const int width_px = layout.cell_px * static_cast<int>(times_s.size());
  const int words_px = width_px / 2 - kStripFont_px;
  const int baseline_px = (kStripBar_px + 2 * kStripFont_px / 3) / 2;
  filters += ",pad=iw:ih+" + Pixels(layout.bar_px) + ":0:" + Pixels(layout.bar_px) +
             ":color=" + Hex(heading.outcome.color);
  filters += Write(FitText(heading.label, words_px, kStripFont_px),
                   {Pixels(kStripFont_px / 2), baseline_px, 0.0}, graph);
  filters += Write(FitText(heading.outcome.text, words_px, kStripFont_px),
                   {"w-tw-" + Pixels(kStripFont_px / 2), baseline_px, 0.0}, graph);
  return filters + "[row" + std::to_string(row) + "];";
}

}  // namespace

FittedText FitText(const std::string& text, int width_px, int largest_px) {
  FittedText fitted{text, largest_px};
  for (char& c : fitted.text) {
    if (static_cast<unsigned char>(c) < 0x20U || c == 0x7F) c = ' ';
  }
  const double advance = Advance(fitted.text);
  if (advance > 0.0) fitted.font_px = std::min(largest_px, static_cast<int>(width_px / advance));
  fitted.font_px = std::max({1, largest_px / 2, fitted.font_px});
  if (advance * fitted.font_px <= width_px) return fitted;
  while (!fitted.text.empty() && Advance(fitted.text + "..") * fitted.font_px > width_px) {
    while (!StartsLetter(fitted.text.back())) fitted.text.pop_back();
    fitted.text.pop_back();
  }
  fitted.text += "..";
  return fitted;
}

FilmLayout LayOutFilm(const std::array<VideoInfo, 2>& videos) {
  const auto& [left, right] = videos;
  FilmLayout layout;
  layout.height_px = Even(std::max(left.height_px, right.height_px));
  for (std::size_t i = 0; i < videos.size(); ++i) {
    layout.width_px[i] =
        Even(static_cast<double>(videos[i].width_px) * layout.height_px / videos[i].height_px);
  }
  layout.bar_px = Even(kBarShare * layout.height_px);
  layout.gap_px = Even(layout.height_px / 120.0);
  const VideoInfo& faster = left.fps >= right.fps ? left : right;
  layout.rate = faster.rate;
  const double longer_s = std::max(left.duration_s, right.duration_s);
  layout.frames = std::max(1, static_cast<int>(std::lround(longer_s * faster.fps)));
  return layout;
}

FilterGraph FilmGraph(const FilmLayout& layout, const std::array<Heading, 2>& headings) {
  FilterGraph graph;
  const std::string left = Half(layout, 0, headings[0], &graph);
  const std::string right = Half(layout, 1, headings[1], &graph);
  graph.graph = left + right + "[half0][half1]hstack[out]";
  return graph;
}

StripLayout LayOutStrip(std::size_t columns) {
  SIDESTEP_REQUIRE(columns > 0, columns);
  StripLayout layout;
  const int room_px = kStripWidth_px / static_cast<int>(columns);
  layout.cell_px = std::max(2, std::min(kLargestCell_px, room_px) / 2 * 2);
  layout.drawn_width_px = Even(4.0 / 3.0 * layout.cell_px);  // as wide a view as the videos'
  layout.bar_px = kStripBar_px;
  return layout;
}

FilterGraph StripGraph(const StripLayout& layout, const std::vector<double>& times_s,
                       const std::array<Heading, 2>& headings) {
  FilterGraph graph;
  const std::string first = StripRow(layout, times_s, 0, headings[0], &graph);
  const std::string second = StripRow(layout, times_s, 1, headings[1], &graph);
  graph.graph = first + second + "[row0][row1]vstack[out]";
  return graph;
}

}  // namespace sidestep::render
