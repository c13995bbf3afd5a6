// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// drawing: a picture as a list of shapes, for more than one kind of file.
//
// Coordinates are pixels, x to the right and y downwards. Colours are roles, which a page may show
// otherwise in the dark, or `#rrggbb` where they stand for a number.

#include <string>
#include <utility>
#include <vector>

namespace sidestep::map {

/// Roles of colours.
namespace ink {
inline constexpr const char* kNone = "";
inline constexpr const char* kPage = "page";
inline constexpr const char* kText = "text";
inline constexpr const char* kSoft = "soft";  ///< Words of less weight, axes.
inline constexpr const char* kGrid = "grid";
inline constexpr const char* kRecovered = "recovered";
inline constexpr const char* kLost = "lost";
inline constexpr const char* kInvalid = "invalid";
inline constexpr const char* kLimit = "limit";           ///< Of the pendulum: an outline.
inline constexpr const char* kLimitArea = "limit-area";  ///< What it encloses.
}  // namespace ink

struct Point {
  double x{0.0};
  double y{0.0};
};

/// How a shape is painted; `ink::kNone` is not at all.
struct Paint {
  std::string fill;
  std::string stroke;
  double width{1.0};
  bool is_dashed{false};
};

enum class Anchor { kStart, kMiddle, kEnd };

struct Shape {
  enum class Kind { kLine, kPolygon, kCircle, kText };
  Kind kind{Kind::kLine};
  std::vector<Point> points;  ///< Of a circle its centre; of a text where its middle line is.
  Paint paint;                ///< A text is filled.
  double size{0.0};           ///< A circle's radius, a text's height.
  std::string text;
  Anchor anchor{Anchor::kStart};
  bool is_bold{false};
  std::string link;   ///< Anchor in a page that it leads to, or nothing.
  std::string title;  ///< What is shown of a link when it is pointed at.
};

/// A text's looks.
struct TextStyle {
  double size{13.0};
  Anchor anchor{Anchor::kStart};
  std::string color{ink::kText};
  bool is_bold{false};
};

class Drawing {
 public:
  Drawing(double width, double height) : width_(width), height_(height) {}

  double width() const { return width_; }
  double height() const { return height_; }
  const std::vector<Shape>& shapes() const { return shapes_; }

  void Line(std::vector<Point> points, Paint paint);
  void Polygon(std::vector<Point> points, Paint paint);
  void Rectangle(Point corner, double width, double height, Paint paint);
  void Circle(Point centre, double radius, Paint paint);
  void Text(Point at, std::string text, const TextStyle& style = {});

  /// Shapes from here on lead to `link`; none of an empty one.
  void SetLink(std::string link, std::string title);

  /// Adds all of `other` with its corner at `corner`, and grows to hold it.
  void Place(const Drawing& other, Point corner);

 private:
  void Add(Shape shape);

  double width_;
  double height_;
  std::vector<Shape> shapes_;
  std::string link_;
  std::string title_;
};

/// `#rrggbb` of a role on a light page; of any other colour itself.
std::string LightColor(const std::string& color);

/// CSS that gives every role its colour, on a light page and in the dark.
std::string RoleStyles();

/// An <svg> element for a page that has RoleStyles(). @param label  For who can't see it.
std::string SvgElement(const Drawing& drawing, const std::string& label);

/// A whole SVG file, without links.
std::string SvgFile(const Drawing& drawing, const std::string& label);

/// A gnuplot script that writes a PNG to its output, light, `scale` pixels a pixel.
std::string PngScript(const Drawing& drawing, double scale);

/// The PNG, by gnuplot. @throws ConfigError if it can't be started or fails.
std::string PngFile(const Drawing& drawing, double scale);

}  // namespace sidestep::map
