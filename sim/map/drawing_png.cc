// SPDX-License-Identifier: BSD-3-Clause
// A drawing through gnuplot: its shapes are objects, arrows and labels of an empty plot.

#include <cstdio>

#include "sim/map/drawing.h"
#include "sim/process/gnuplot.h"

namespace sidestep::map {
namespace {

std::string Coordinate(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f", value);
  return text;
}

std::string At(const Point& point) { return Coordinate(point.x) + "," + Coordinate(point.y); }

std::string Color(const std::string& color) { return " rgb '" + LightColor(color) + "'"; }

std::string Border(const Paint& paint) {
  if (paint.stroke.empty()) return " noborder";
  return " border lc" + Color(paint.stroke);
}

std::string Dash(const Paint& paint) { return paint.is_dashed ? " dashtype (4,3)" : ""; }

std::string Filled(const Paint& paint, double scale) {
  const std::string width = " lw " + Coordinate(scale * paint.width);
  if (paint.fill.empty()) return " fillstyle empty" + Border(paint) + width + Dash(paint);
  return " fc" + Color(paint.fill) + " fillstyle solid 1.0" + Border(paint) + width + Dash(paint);
}

// Objects keep their order, arrows lie on top of all: so a line is a polygon there and back, unless
// it has dashes, which would fill each other's gaps.
std::string LineText(const Shape& shape, double scale) {
  if (!shape.paint.is_dashed) {
    std::string path = At(shape.points.front());
    for (std::size_t i = 1; i < shape.points.size(); ++i) path += " to " + At(shape.points[i]);
    for (std::size_t i = shape.points.size() - 1; i-- > 0;) path += " to " + At(shape.points[i]);
    return "set object polygon from " + path + " front" + Filled(shape.paint, scale) + "\n";
  }
  std::string text;
  for (std::size_t i = 1; i < shape.points.size(); ++i) {
    text += "set arrow from " + At(shape.points[i - 1]) + " to " + At(shape.points[i]) +
            " nohead front lc" + Color(shape.paint.stroke) + " lw " +
            Coordinate(scale * shape.paint.width) + Dash(shape.paint) + "\n";
  }
  return text;
}

std::string PolygonText(const Shape& shape, double scale) {
  std::string corners;
  for (const Point& point : shape.points) corners += (corners.empty() ? "" : " to ") + At(point);
  corners += " to " + At(shape.points.front());
  return "set object polygon from " + corners + " front" + Filled(shape.paint, scale) + "\n";
}

std::string LabelText(const Shape& shape, double scale) {
  const char* side = shape.anchor == Anchor::kStart    ? " left"
                     : shape.anchor == Anchor::kMiddle ? " center"
                                                       : " right";
  constexpr double kPointsAPixel = 0.75;
  const std::string font = std::string("DejaVu Sans") + (shape.is_bold ? ":Bold" : "") + "," +
                           Coordinate(scale * kPointsAPixel * shape.size);
  return "set label " + GnuplotText(shape.text) + " at " + At(shape.points.front()) + side +
         " noenhanced front font '" + font + "' textcolor" + Color(shape.paint.fill) + "\n";
}

std::string ShapeText(const Shape& shape, double scale) {
  switch (shape.kind) {
    case Shape::Kind::kLine:
      return LineText(shape, scale);
    case Shape::Kind::kPolygon:
      return PolygonText(shape, scale);
    case Shape::Kind::kCircle:
      return "set object circle at " + At(shape.points.front()) + " size " +
             Coordinate(shape.size) + " front" + Filled(shape.paint, scale) + "\n";
    case Shape::Kind::kText:
      break;
  }
  return LabelText(shape, scale);
}

}  // namespace

std::string PngScript(const Drawing& drawing, double scale) {
  const std::string width = Coordinate(drawing.width());
  const std::string height = Coordinate(drawing.height());
  std::string text = "set encoding utf8\nset terminal pngcairo background rgb '" +
                     LightColor(ink::kPage) + "' size " +
                     std::to_string(static_cast<int>(scale * drawing.width())) + "," +
                     std::to_string(static_cast<int>(scale * drawing.height())) +
                     "\nunset border\nunset tics\nunset key\n"
                     "set lmargin 0\nset rmargin 0\nset tmargin 0\nset bmargin 0\n"
                     "set xrange [0:" +
                     width + "]\nset yrange [" + height + ":0]\n";
  for (const Shape& shape : drawing.shapes()) text += ShapeText(shape, scale);
  return text + "plot NaN notitle\n";
}

std::string PngFile(const Drawing& drawing, double scale) {
  return RunGnuplot({"-"}, PngScript(drawing, scale));
}

}  // namespace sidestep::map
