#pragma once
// A small SVG picture, written from the back to the front. Sizes and places in px, y downwards. It brings its
// own white ground, so that it reads on white pages and dark ones. One thread.

#include <sstream>
#include <string>
#include <vector>

namespace svchain::page {

inline constexpr const char* kGround = "#ffffff";
inline constexpr const char* kInk = "#222b36";
inline constexpr const char* kPaleInk = "#5b6470";
inline constexpr const char* kGridColour = "#dde2e8";

struct Point {
  double x, y;
};

enum class Anchor { kStart, kMiddle, kEnd };

struct TextStyle {
  int size_px = 12;
  Anchor anchor = Anchor::kStart;
  const char* colour = kInk;
  bool bold = false;
  bool upwards = false;  // turned by 90 degrees, to be read from the right
};

class Svg {
 public:
  Svg(double width, double height);

  void text(const Point& at, const std::string& what, const TextStyle& style);
  void rectangle(const Point& corner, double width, double height, const std::string& fill);
  void line(const Point& from, const Point& to, const std::string& colour, double width, bool dashed = false);
  void polyline(const std::vector<Point>& points, const std::string& colour, double width);
  void dot(const Point& at, double radius, const std::string& fill);

  /// The whole file.
  std::string str() const { return out_.str() + "</svg>\n"; }

 private:
  std::ostringstream out_;
};

/// Room for a text, px; rather too much than too little.
double text_width(const std::string& what, int size_px);

/// A number as an axis shows it, without digits that say nothing: "0.5", "20", "1000".
std::string axis_number(double value);

}  // namespace svchain::page
