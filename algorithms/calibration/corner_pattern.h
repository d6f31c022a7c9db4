#pragma once
// How bright a picture is around a corner of a chart: two straight edges cross, between them quarters are
// light or dark, and all is blurred by a Gaussian. With a and b the signed distances from the edges in units
// of the blur and rho the cosine between the edges' normals, the blurred quarter on the positive side of both
// is the bivariate normal distribution
//   P(a, b; rho) = Phi(a) Phi(b) + phi(a) phi(b) sum_n rho^(n+1) / (n+1)! He_n(a) He_n(b)
// (Mehler's formula, integrated; Kibble 1945), the other quarters follow from it, Phi(a) and Phi(b). Thus the
// model holds for slanted corners too, where a product of two steps would pull the corner aside. Pure values.

#include <Eigen/Core>

#include "algorithms/calibration/charts.h"

namespace svchain::calibration {

/// Places in px relative to the middle of a window; see corner_window.h.
struct CornerShape {
  static constexpr int kCount = 9;
  using Vector = Eigen::Matrix<double, kCount, 1>;

  Eigen::Vector2d corner_px = {0, 0};
  /// Directions of the edges' normals: of the edge x = 0 of the chart towards +x, of y = 0 towards +y.
  Eigen::Vector2d normals_rad = {0, 0};
  double log_blur = 0;                      // of the optics' sigma in px
  double light = 0;                         // grey levels, in the window's middle
  double contrast = 0;                      // light minus dark
  Eigen::Vector2d shading_per_px = {0, 0};  // relative, of light and dark alike

  /// Sigma of the optics and a pixel's width together.
  double blur_px() const;
  CornerShape moved(const Vector& step) const;
};

class CornerPattern {
 public:
  CornerPattern(const CornerShape& shape, DarkQuarters dark);

  struct Brightness {
    double grey;
    double darkness;               // 0 light, 1 dark
    CornerShape::Vector gradient;  // of grey, in the order of CornerShape's members
  };
  Brightness at(const Eigen::Vector2d& place_px) const;

  /// Whether quarters so darkened have a corner at all; two neighbours make a straight edge.
  static bool is_corner(DarkQuarters dark);

 private:
  CornerShape shape_;
  Eigen::Vector2d normal_x_;
  Eigen::Vector2d normal_y_;
  double per_blur_;
  double blur_rise_;  // d log blur_px / d log_blur
  double rho_;
  // darkness = all + x Phi(a) + y Phi(b) + both P(a, b)
  double all_;
  double x_;
  double y_;
  double both_;
};

}  // namespace svchain::calibration
