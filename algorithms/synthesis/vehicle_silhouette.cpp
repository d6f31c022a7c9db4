#include "algorithms/synthesis/vehicle_silhouette.h"

#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

namespace svchain::synthesis {
namespace {

constexpr int kSubpixelBits = 6;

/// A point of the car: forward and to the left, both -1..1 from end to end and side to side.
struct CarPoint {
  double forward;
  double left;
};
using Outline = std::vector<CarPoint>;

/// Rounded rectangle as a superellipse: `sharpness` 2 is an ellipse, more is squarer.
Outline rounded(double rear, double front, double half_width, double sharpness) {
  Outline outline;
  for (int i = 0; i < 128; ++i) {
    const double t = i * CV_2PI / 128, c = std::cos(t), s = std::sin(t);
    const auto bulge = [&](double v) { return std::copysign(std::pow(std::abs(v), 2 / sharpness), v); };
    outline.push_back({(rear + front) / 2 + (front - rear) / 2 * bulge(c), half_width * bulge(s)});
  }
  return outline;
}

/// The same shape on the right.
Outline mirrored(Outline outline) {
  for (CarPoint& p : outline) p.left = -p.left;
  return outline;
}

class Brush {
 public:
  Brush(cv::Mat& canvas, const geometry::Vehicle& vehicle, const geometry::View& view)
      : canvas_(canvas), vehicle_(vehicle), view_(view) {}

  void fill(const Outline& outline, int grey) const {
    std::vector<cv::Point> points;
    for (const CarPoint& p : outline) points.push_back(place(p));
    cv::fillPoly(canvas_, points, cv::Scalar::all(grey), cv::LINE_AA, kSubpixelBits);
  }
  void fill_both_sides(const Outline& outline, int grey) const {
    fill(outline, grey);
    fill(mirrored(outline), grey);
  }

 private:
  cv::Point place(const CarPoint& p) const {
    const Eigen::Vector2d px =
        view_.pixel_from_ground({p.forward * vehicle_.length_m / 2, p.left * vehicle_.width_m / 2});
    // Far outside the picture exact places matter no more, but must not overflow.
    const auto fixed = [](double v) { return cvRound(std::clamp(v, -1e5, 1e5) * (1 << kSubpixelBits)); };
    return {fixed(px.x()), fixed(px.y())};
  }

  cv::Mat& canvas_;
  const geometry::Vehicle& vehicle_;
  const geometry::View& view_;
};

void draw_body(const Brush& brush) {
  for (const double axle : {0.60, -0.62})
    brush.fill_both_sides({{axle - 0.13, 0.99}, {axle + 0.13, 0.99}, {axle + 0.13, 0.7}, {axle - 0.13, 0.7}},
                          28);
  brush.fill(rounded(-0.995, 0.995, 0.945, 5), 96);    // sill, darker than what lies above it
  brush.fill(rounded(-0.985, 0.985, 0.90, 4.6), 158);  // body
  brush.fill({{0.32, 0.74}, {0.86, 0.60}, {0.90, 0}, {0.86, -0.60}, {0.32, -0.74}}, 172);       // bonnet
  brush.fill({{-0.72, 0.70}, {-0.93, 0.62}, {-0.95, 0}, {-0.93, -0.62}, {-0.72, -0.70}}, 168);  // boot
  brush.fill_both_sides({{0.93, 0.50}, {0.84, 0.80}, {0.79, 0.82}, {0.87, 0.52}}, 222);         // headlights
  brush.fill_both_sides({{-0.95, 0.52}, {-0.90, 0.80}, {-0.86, 0.80}, {-0.91, 0.52}}, 70);      // tail lights
  brush.fill_both_sides({{0.27, 0.84}, {0.30, 0.99}, {0.235, 0.985}, {0.215, 0.84}}, 120);      // mirrors
}

void draw_cabin(const Brush& brush) {
  brush.fill(rounded(-0.80, 0.38, 0.83, 6), 44);  // glass all around
  brush.fill({{0.345, 0.60}, {0.36, 0}, {0.345, -0.60}, {0.14, -0.66}, {0.14, 0.66}}, 58);
  brush.fill(rounded(-0.62, 0.16, 0.70, 7), 188);  // roof
  brush.fill(rounded(-0.58, 0.11, 0.61, 7), 200);
  brush.fill_both_sides({{0.16, 0.62}, {0.375, 0.76}, {0.355, 0.81}, {0.10, 0.68}}, 158);     // front pillars
  brush.fill_both_sides({{-0.58, 0.66}, {-0.785, 0.74}, {-0.76, 0.81}, {-0.50, 0.70}}, 158);  // rear pillars
  brush.fill_both_sides({{-0.20, 0.69}, {-0.20, 0.84}, {-0.235, 0.84}, {-0.235, 0.69}}, 158);  // door pillars
}

}  // namespace

cv::Mat vehicle_silhouette(const geometry::Vehicle& vehicle, const geometry::View& view) {
  cv::Mat canvas(view.size_px.y(), view.size_px.x(), CV_8UC3, cv::Scalar::all(0));
  const Brush brush(canvas, vehicle, view);
  draw_body(brush);
  draw_cabin(brush);
  return canvas;
}

}  // namespace svchain::synthesis
