// SPDX-License-Identifier: BSD-3-Clause
#include "sim/render/film_graph.h"

#include <gtest/gtest.h>

namespace sidestep::render::film_graph_test {
namespace {

TEST(FitTextTest, ShortWordsAreAsLargeAsAllowed) {
  const FittedText fitted = FitText("without", 640, 28);
  EXPECT_EQ(fitted.text, "without");
  EXPECT_EQ(fitted.font_px, 28);
}

TEST(FitTextTest, LongWordsShrinkToHalfAndAreThenCut) {
  const std::string name(40, 'n');  // 40 letters of 0.62: 24.8 times the font's size
  EXPECT_EQ(FitText(name, 500, 28).text, name);
  EXPECT_EQ(FitText(name, 500, 28).font_px, 20);
  const FittedText cut = FitText(name, 200, 28);
  EXPECT_EQ(cut.font_px, 14);
  EXPECT_EQ(cut.text, std::string(21, 'n') + "..") << "23 letters of 8.68 fit into 200";
}

TEST(FitTextTest, ALetterIsNeverCutInTwo) {
  const FittedText cut = FitText("ééééééééééééé", 60, 20);  // of two bytes each, 10 wide
  EXPECT_EQ(cut.text, "éééé..");
}

TEST(FitTextTest, WordsStayOnOneLine) {
  EXPECT_EQ(FitText("a\nb\tc", 640, 20).text, "a b c");
  EXPECT_EQ(FitText("", 640, 20).text, "");
  EXPECT_EQ(FitText("abc", 1, 20).text, "..") << "no room at all";
}

TEST(LayOutFilmTest, TheFilmHasTheLargerHeightTheFasterRateAndTheLongerTime) {
  const VideoInfo left{640, 480, "30/1", 30.0, 10.5};
  const VideoInfo right{320, 180, "50/1", 50.0, 14.0};
  const FilmLayout layout = LayOutFilm({left, right});
  EXPECT_EQ(layout.height_px, 480);
  EXPECT_EQ(layout.width_px[0], 640);
  EXPECT_EQ(layout.width_px[1], 854) << "480 x 16 / 9 = 853.3, made even";
  EXPECT_EQ(layout.bar_px, 80);
  EXPECT_EQ(layout.gap_px, 4);
  EXPECT_EQ(layout.rate, "50/1");
  EXPECT_EQ(layout.frames, 700);
}

TEST(LayOutStripTest, AStripIsAtMost1400WideAndItsPicturesEven) {
  for (std::size_t columns = 1; columns <= 12; ++columns) {
    const StripLayout layout = LayOutStrip(columns);
    EXPECT_LE(layout.cell_px * static_cast<int>(columns), 1400);
    EXPECT_EQ(layout.cell_px % 2, 0);
    EXPECT_EQ(layout.drawn_width_px % 2, 0);
    EXPECT_GT(layout.drawn_width_px, layout.cell_px) << "there are sides to cut off";
  }
  EXPECT_EQ(LayOutStrip(5).cell_px, 280);
  EXPECT_EQ(LayOutStrip(1).cell_px, 350);
}

TEST(FilmGraphTest, WordsAreInFilesNeverInTheGraph) {
  const std::string nasty = "it's 50%: [a],b;\\";
  const Heading heading{nasty, {nasty, Eigen::Vector3f::Zero(), 1.5}};
  const FilmLayout layout{{640, 640}, 480, 80, 4, "30/1", 100};
  for (const FilterGraph& graph : {FilmGraph(layout, {heading, heading}),
                                   StripGraph(LayOutStrip(2), {1.0, 2.0}, {heading, heading})}) {
    EXPECT_EQ(graph.graph.find("50%"), std::string::npos) << graph.graph;
    EXPECT_EQ(std::count_if(graph.text_files.begin(), graph.text_files.end(),
                            [&](const auto& file) { return file.second == nasty; }),
              4);
  }
}

}  // namespace
}  // namespace sidestep::render::film_graph_test
