#include "algorithms/calibration/corner_pattern.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace svchain::calibration {

namespace {

constexpr double kPixelVariance = 1.0 / 12;  // what a pixel's own width blurs, even in a sharpened picture
constexpr double kLeastLogBlur = -2.3;       // 0.1 px: nothing beside a pixel's width
constexpr double kMostLogBlur = 1.6;         // 5 px
constexpr double kFar = 4;                   // sigmas from an edge: nothing of its blur is left

struct Step {
  double height;  // Phi
  double slope;   // phi
};

Step step_at(double a) {
  if (a > kFar) return {1, 0};
  if (a < -kFar) return {0, 0};
  const double density = std::exp(-0.5 * a * a) / std::sqrt(2 * std::numbers::pi);
  return {0.5 * std::erfc(-a / std::numbers::sqrt2), density};
}

/// P(a, b; rho) and its derivatives.
struct Quarter {
  double height, by_a, by_b, by_rho;
};

Quarter quarter_at(double a, double b, const Step& x, const Step& y, double rho) {
  Quarter q{x.height * y.height, x.slope * y.height, x.height * y.slope, x.slope * y.slope};
  const double both = x.slope * y.slope;
  if (both == 0) return q;
  constexpr int kTerms = 16;
  constexpr double kNothing = 1e-6;
  double share = 1;  // |rho|^n
  q.by_rho = 0;
  double power = 1;               // rho^n / n!
  double he_a = 1, he_b = 1;      // He_n
  double last_a = 0, last_b = 0;  // He_(n-1)
  for (int n = 0; n < kTerms; ++n) {
    const double next_a = a * he_a - n * last_a, next_b = b * he_b - n * last_b;
    q.by_rho += both * power * he_a * he_b;
    power *= rho / (n + 1);
    share *= std::abs(rho);  // He_n squared grows like n!
    if (share < kNothing) break;
    q.height += both * power * he_a * he_b;
    q.by_a -= both * power * next_a * he_b;
    q.by_b -= both * power * he_a * next_b;
    last_a = he_a, last_b = he_b;
    he_a = next_a, he_b = next_b;
  }
  return q;
}

Eigen::Vector2d direction(double angle_rad) {
  return {std::cos(angle_rad), std::sin(angle_rad)};
}

Eigen::Vector2d turned_left(const Eigen::Vector2d& v) {
  return {-v.y(), v.x()};
}

}  // namespace

CornerShape CornerShape::moved(const Vector& step) const {
  CornerShape shape = *this;
  shape.corner_px += step.segment<2>(0);
  shape.normals_rad += step.segment<2>(2);
  shape.log_blur = std::clamp(log_blur + step[4], kLeastLogBlur, kMostLogBlur);
  shape.light += step[5];
  shape.contrast += step[6];
  shape.shading_per_px += step.segment<2>(7);
  return shape;
}

double CornerShape::blur_px() const {
  return std::sqrt(std::exp(2 * log_blur) + kPixelVariance);
}

CornerPattern::CornerPattern(const CornerShape& shape, DarkQuarters dark)
    : shape_(shape),
      normal_x_(direction(shape.normals_rad.x())),
      normal_y_(direction(shape.normals_rad.y())),
      per_blur_(1 / shape.blur_px()),
      blur_rise_(std::exp(2 * shape.log_blur) * per_blur_ * per_blur_),
      rho_(normal_x_.dot(normal_y_)) {
  const double q[4] = {double(dark & 1), double(dark >> 1 & 1), double(dark >> 2 & 1), double(dark >> 3 & 1)};
  all_ = q[2];
  x_ = q[3] - q[2];
  y_ = q[1] - q[2];
  both_ = q[0] - q[1] + q[2] - q[3];
}

CornerPattern::Brightness CornerPattern::at(const Eigen::Vector2d& place_px) const {
  const Eigen::Vector2d off = place_px - shape_.corner_px;
  const double a = normal_x_.dot(off) * per_blur_, b = normal_y_.dot(off) * per_blur_;
  const Step x = step_at(a), y = step_at(b);
  const Quarter q = quarter_at(a, b, x, y, rho_);
  const double darkness = all_ + x_ * x.height + y_ * y.height + both_ * q.height;
  const double by_a = x_ * x.slope + both_ * q.by_a, by_b = y_ * y.slope + both_ * q.by_b;
  const double by_rho = both_ * q.by_rho;

  const double shade = 1 + shape_.shading_per_px.dot(place_px);
  const double unshaded = shape_.light - shape_.contrast * darkness;
  const double scale = shade * shape_.contrast;
  const Eigen::Vector2d tangent_x = turned_left(normal_x_), tangent_y = turned_left(normal_y_);
  CornerShape::Vector g;
  g.segment<2>(0) = scale * per_blur_ * (by_a * normal_x_ + by_b * normal_y_);
  g[2] = -scale * (by_a * tangent_x.dot(off) * per_blur_ + by_rho * tangent_x.dot(normal_y_));
  g[3] = -scale * (by_b * tangent_y.dot(off) * per_blur_ + by_rho * tangent_y.dot(normal_x_));
  g[4] = scale * blur_rise_ * (by_a * a + by_b * b);
  g[5] = shade;
  g[6] = -shade * darkness;
  g.segment<2>(7) = unshaded * place_px;
  return {shade * unshaded, darkness, g};
}

bool CornerPattern::is_corner(DarkQuarters dark) {
  return CornerPattern({}, dark).both_ != 0;
}

}  // namespace svchain::calibration
