// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <cstdio>

#include "sim/map/drawing.h"
#include "sim/palette/palette.h"
#include "sim/report/html.h"

namespace sidestep::map {
namespace {

struct Role {
  const char* name;
  palette::Shades shades;
};

constexpr std::array<Role, 9> kRoles{{{ink::kPage, palette::kCard},
                                      {ink::kText, palette::kInk},
                                      {ink::kSoft, palette::kSoftInk},
                                      {ink::kGrid, palette::kMapGrid},
                                      {ink::kRecovered, palette::kRecovered},
                                      {ink::kLost, palette::kLost},
                                      {ink::kInvalid, palette::kUndecided},
                                      {ink::kLimit, palette::kPendulum},
                                      {ink::kLimitArea, palette::kPendulumArea}}};

const Role* RoleOf(const std::string& color) {
  for (const Role& role : kRoles) {
    if (color == role.name) return &role;
  }
  return nullptr;
}

std::string Css(const std::string& color) {
  if (color.empty()) return "none";
  return RoleOf(color) != nullptr ? "var(--map-" + color + ")" : color;
}

std::string Figure(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f", value);
  return text;
}

std::string PointsText(const std::vector<Point>& points) {
  std::string text;
  for (const Point& point : points) {
    text += (text.empty() ? "" : " ") + Figure(point.x) + "," + Figure(point.y);
  }
  return text;
}

std::string PaintText(const Paint& paint) {
  std::string text = " style=\"fill:" + Css(paint.fill) + ";stroke:" + Css(paint.stroke);
  if (!paint.stroke.empty()) text += ";stroke-width:" + Figure(paint.width);
  if (paint.is_dashed) text += ";stroke-dasharray:4 3";
  return text + "\"";
}

std::string TextElement(const Shape& shape) {
  constexpr double kMiddleToBaseline = 0.35;  // of the height, of most fonts
  constexpr std::array<const char*, 3> kAnchors{"start", "middle", "end"};
  const Point at = shape.points.front();
  return "<text x=\"" + Figure(at.x) + "\" y=\"" + Figure(at.y + kMiddleToBaseline * shape.size) +
         "\" font-size=\"" + Figure(shape.size) + "\" text-anchor=\"" +
         kAnchors[static_cast<std::size_t>(shape.anchor)] + "\"" +
         (shape.is_bold ? " font-weight=\"700\"" : "") + PaintText(shape.paint) + ">" +
         report::Escaped(shape.text) + "</text>\n";
}

std::string Element(const Shape& shape) {
  switch (shape.kind) {
    case Shape::Kind::kLine:
      return "<polyline points=\"" + PointsText(shape.points) + "\"" + PaintText(shape.paint) +
             "/>\n";
    case Shape::Kind::kPolygon:
      return "<polygon points=\"" + PointsText(shape.points) + "\"" + PaintText(shape.paint) +
             "/>\n";
    case Shape::Kind::kCircle:
      return "<circle cx=\"" + Figure(shape.points.front().x) + "\" cy=\"" +
             Figure(shape.points.front().y) + "\" r=\"" + Figure(shape.size) + "\"" +
             PaintText(shape.paint) + "/>\n";
    case Shape::Kind::kText:
      break;
  }
  return TextElement(shape);
}

// Neighbours with the same link share one.
std::string Elements(const Drawing& drawing, bool with_links) {
  std::string text;
  std::string open;
  for (const Shape& shape : drawing.shapes()) {
    const std::string link = with_links ? shape.link : "";
    if (link != open) {
      if (!open.empty()) text += "</a>\n";
      if (!link.empty()) {
        text += "<a href=\"#" + report::Escaped(link) + "\"><title>" +
                report::Escaped(shape.title) + "</title>\n";
      }
      open = link;
    }
    text += Element(shape);
  }
  return open.empty() ? text : text + "</a>\n";
}

std::string Head(const Drawing& drawing, const std::string& label, const std::string& more) {
  const std::string size = Figure(drawing.width()) + " " + Figure(drawing.height());
  return "<svg" + more + " viewBox=\"0 0 " + size + "\" role=\"img\" aria-label=\"" +
         report::Escaped(label) + "\" font-family=\"'DejaVu Sans', system-ui, sans-serif\">\n";
}

}  // namespace

std::string LightColor(const std::string& color) {
  const Role* role = RoleOf(color);
  return role != nullptr ? role->shades.light : color;
}

std::string RoleStyles() {
  std::string light, dark;
  for (const Role& role : kRoles) {
    light += std::string("--map-") + role.name + ":" + role.shades.light + ";";
    dark += std::string("--map-") + role.name + ":" + role.shades.dark + ";";
  }
  return ":root{" + light + "}\n@media (prefers-color-scheme: dark){:root{" + dark + "}}\n";
}

std::string SvgElement(const Drawing& drawing, const std::string& label) {
  return Head(drawing, label, " style=\"width:" + Figure(drawing.width()) + "px\"") +
         Elements(drawing, true) + "</svg>\n";
}

std::string SvgFile(const Drawing& drawing, const std::string& label) {
  const std::string size = " xmlns=\"http://www.w3.org/2000/svg\" width=\"" +
                           Figure(drawing.width()) + "\" height=\"" + Figure(drawing.height()) +
                           "\"";
  return Head(drawing, label, size) + "<style>" + RoleStyles() + "</style>\n" +
         "<rect width=\"100%\" height=\"100%\" style=\"fill:var(--map-page)\"/>\n" +
         Elements(drawing, false) + "</svg>\n";
}

}  // namespace sidestep::map
