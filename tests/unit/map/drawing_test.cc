// SPDX-License-Identifier: BSD-3-Clause
#include "sim/map/drawing.h"

#include <gtest/gtest.h>

#include <string>

#include "sim/map/pictures.h"
#include "sim/palette/palette.h"
#include "tests/unit/map/made_map.h"

namespace sidestep::map {
namespace {

TEST(DrawingTest, HostileTextStaysText) {
  Drawing drawing(100.0, 50.0);
  drawing.Text({1.0, 2.0}, "<script>'\"&\n`x`");
  const std::string svg = SvgElement(drawing, "\"><b>");
  EXPECT_TRUE(Has(svg, "&lt;script&gt;&#39;&quot;&amp;"));
  EXPECT_TRUE(Has(svg, "aria-label=\"&quot;&gt;&lt;b&gt;\""));
  EXPECT_FALSE(Has(svg, "<script"));
  const std::string script = PngScript(drawing, 1.0);
  EXPECT_TRUE(Has(script, "set label '<script>''\"& `x`' at")) << script;
}

TEST(DrawingTest, LinksArePartOfAPageButNotOfAFile) {
  Drawing drawing(10.0, 10.0);
  drawing.SetLink("cell-1", "a & b");
  drawing.Circle({1.0, 1.0}, 1.0, {ink::kText, ink::kNone});
  drawing.Circle({2.0, 1.0}, 1.0, {ink::kText, ink::kNone});
  drawing.SetLink("", "");
  drawing.Circle({3.0, 1.0}, 1.0, {ink::kText, ink::kNone});
  const std::string svg = SvgElement(drawing, "l");
  EXPECT_EQ(svg.find("<a "), svg.rfind("<a ")) << "neighbours share a link";
  EXPECT_TRUE(Has(svg, "<a href=\"#cell-1\"><title>a &amp; b</title>"));
  EXPECT_FALSE(Has(SvgFile(drawing, "l"), "<a "));
}

TEST(DrawingTest, PlacingMovesAndGrows) {
  Drawing inner(10.0, 20.0);
  inner.Circle({1.0, 2.0}, 1.0, {});
  Drawing outer(5.0, 5.0);
  outer.Place(inner, {3.0, 4.0});
  EXPECT_EQ(outer.width(), 13.0);
  EXPECT_EQ(outer.height(), 24.0);
  EXPECT_EQ(outer.shapes()[0].points[0].x, 4.0);
  EXPECT_EQ(outer.shapes()[0].points[0].y, 6.0);
}

TEST(DrawingTest, GnuplotDrawsAWholeMap) {
  const std::string png = PngFile(SheetPicture(MadeMap()), 1.0);
  ASSERT_GT(png.size(), 10000U);
  EXPECT_EQ(png.substr(1, 3), "PNG");
}

TEST(PicturesTest, MarksDifferByShape) {
  Drawing recovered(1, 1), lost(1, 1), invalid(1, 1);
  DrawMark(Survival::kSurvived, {}, 1.0, &recovered);
  DrawMark(Survival::kLost, {}, 1.0, &lost);
  DrawMark(Survival::kInvalid, {}, 1.0, &invalid);
  EXPECT_EQ(recovered.shapes()[0].kind, Shape::Kind::kCircle);
  EXPECT_EQ(lost.shapes()[0].kind, Shape::Kind::kLine);
  EXPECT_EQ(invalid.shapes()[0].kind, Shape::Kind::kPolygon);
}

TEST(PicturesTest, AheadIsUpAndLeftIsLeft) {
  const Drawing polar = PolarPicture(MadeMap(), 0, 0);
  double highest = 1e9, leftmost = 1e9;
  for (const Shape& shape : polar.shapes()) {
    if (shape.kind != Shape::Kind::kCircle || shape.paint.fill != ink::kRecovered) continue;
    highest = std::min(highest, shape.points[0].y);
    leftmost = std::min(leftmost, shape.points[0].x);
  }
  // Survived: 1 ahead, 2 to the left, 3 (the scale's end) back; the dial's centre is (160, 200).
  EXPECT_NEAR(highest, 200.0 - 122.0 / 3.0, 0.1);
  EXPECT_NEAR(leftmost, 160.0 - 2.0 * 122.0 / 3.0, 0.1);
}

TEST(PicturesTest, TicksAreRoundAndFew) {
  EXPECT_DOUBLE_EQ(TickFor(0.8), 0.2);
  EXPECT_DOUBLE_EQ(TickFor(3.0), 1.0);
  EXPECT_DOUBLE_EQ(TickFor(10.0), 2.0);
  EXPECT_EQ(TickFor(0.0), 1.0);
  EXPECT_EQ(TickFor(kUnknown), 1.0);
}

TEST(PicturesTest, ReadsOnBothEndsOfAScale) {
  EXPECT_EQ(ReadableOn(SequentialColor(0.0)), palette::kGround.dark);
  EXPECT_EQ(ReadableOn(SequentialColor(1.0)), palette::kCard.light);
  EXPECT_EQ(ReadableOn(DivergingColor(-1.0)), palette::kCard.light);
  EXPECT_EQ(SequentialColor(kUnknown), ink::kGrid);
}

}  // namespace
}  // namespace sidestep::map
