#include "usecases/svchain_page/svg.h"

#include <cmath>

#include "framework/usecase/svg_text.h"

namespace svchain::page {

namespace {

/// Tenths of a pixel are enough, and keep the file readable.
std::string px(double v) {
  std::ostringstream out;
  out << std::round(v * 10) / 10;
  return out.str();
}

const char* name_of(Anchor anchor) {
  switch (anchor) {
    case Anchor::kMiddle:
      return "middle";
    case Anchor::kEnd:
      return "end";
    default:
      return "start";
  }
}

}  // namespace

Svg::Svg(double width, double height) {
  out_ << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << px(width) << "\" height=\"" << px(height)
       << "\" viewBox=\"0 0 " << px(width) << " " << px(height)
       << "\" font-family=\"Helvetica, Arial, sans-serif\">\n"
       << "<rect width=\"100%\" height=\"100%\" rx=\"6\" fill=\"" << kGround << "\"/>\n";
}

void Svg::text(const Point& at, const std::string& what, const TextStyle& style) {
  out_ << "<text x=\"" << px(at.x) << "\" y=\"" << px(at.y) << "\" font-size=\"" << style.size_px
       << "\" fill=\"" << style.colour << "\" text-anchor=\"" << name_of(style.anchor) << "\""
       << (style.bold ? " font-weight=\"bold\"" : "");
  if (style.upwards) out_ << " transform=\"rotate(-90 " << px(at.x) << " " << px(at.y) << ")\"";
  out_ << ">" << svg_text(what) << "</text>\n";
}

void Svg::rectangle(const Point& corner, double width, double height, const std::string& fill) {
  out_ << "<rect x=\"" << px(corner.x) << "\" y=\"" << px(corner.y) << "\" width=\"" << px(width)
       << "\" height=\"" << px(height) << "\" fill=\"" << fill << "\"/>\n";
}

void Svg::line(const Point& from, const Point& to, const std::string& colour, double width, bool dashed) {
  out_ << "<path d=\"M" << px(from.x) << "," << px(from.y) << " L" << px(to.x) << "," << px(to.y)
       << "\" stroke=\"" << colour << "\" stroke-width=\"" << px(width) << "\""
       << (dashed ? " stroke-dasharray=\"5 4\"" : "") << "/>\n";
}

void Svg::polyline(const std::vector<Point>& points, const std::string& colour, double width) {
  out_ << "<polyline points=\"";
  for (const Point& point : points) out_ << px(point.x) << "," << px(point.y) << " ";
  out_ << "\" fill=\"none\" stroke=\"" << colour << "\" stroke-width=\"" << px(width) << "\"/>\n";
}

void Svg::dot(const Point& at, double radius, const std::string& fill) {
  out_ << "<circle cx=\"" << px(at.x) << "\" cy=\"" << px(at.y) << "\" r=\"" << px(radius) << "\" fill=\""
       << fill << "\"/>\n";
}

double text_width(const std::string& what, int size_px) {
  constexpr double kWidestMean = 0.6;  // of a letter's height
  return kWidestMean * size_px * static_cast<double>(what.size());
}

std::string axis_number(double value) {
  std::ostringstream out;
  out.precision(3);
  if (std::abs(value) >= 1000) out << std::fixed, out.precision(0);
  out << value;
  return out.str();
}

}  // namespace svchain::page
