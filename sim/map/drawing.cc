// SPDX-License-Identifier: BSD-3-Clause
#include "sim/map/drawing.h"

#include <algorithm>

namespace sidestep::map {

void Drawing::Add(Shape shape) {
  shape.link = link_;
  shape.title = title_;
  shapes_.push_back(std::move(shape));
}

void Drawing::Line(std::vector<Point> points, Paint paint) {
  Shape shape;
  shape.points = std::move(points);
  shape.paint = std::move(paint);
  Add(std::move(shape));
}

void Drawing::Polygon(std::vector<Point> points, Paint paint) {
  Shape shape;
  shape.kind = Shape::Kind::kPolygon;
  shape.points = std::move(points);
  shape.paint = std::move(paint);
  Add(std::move(shape));
}

void Drawing::Rectangle(Point corner, double width, double height, Paint paint) {
  Polygon({corner,
           {corner.x + width, corner.y},
           {corner.x + width, corner.y + height},
           {corner.x, corner.y + height}},
          std::move(paint));
}

void Drawing::Circle(Point centre, double radius, Paint paint) {
  Shape shape;
  shape.kind = Shape::Kind::kCircle;
  shape.points = {centre};
  shape.size = radius;
  shape.paint = std::move(paint);
  Add(std::move(shape));
}

void Drawing::Text(Point at, std::string text, const TextStyle& style) {
  Shape shape;
  shape.kind = Shape::Kind::kText;
  shape.points = {at};
  shape.size = style.size;
  shape.paint.fill = style.color;
  shape.text = std::move(text);
  shape.anchor = style.anchor;
  shape.is_bold = style.is_bold;
  Add(std::move(shape));
}

void Drawing::SetLink(std::string link, std::string title) {
  link_ = std::move(link);
  title_ = std::move(title);
}

void Drawing::Place(const Drawing& other, Point corner) {
  for (Shape shape : other.shapes_) {
    for (Point& point : shape.points) point = {point.x + corner.x, point.y + corner.y};
    shapes_.push_back(std::move(shape));
  }
  width_ = std::max(width_, corner.x + other.width_);
  height_ = std::max(height_, corner.y + other.height_);
}

}  // namespace sidestep::map
