#include "algorithms/calibration/corner_fit.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "algorithms/calibration/corner_pattern.h"
#include "algorithms/calibration/corner_window.h"

namespace svchain::calibration {

namespace {

constexpr double kClipped = 254.5;
constexpr double kLeastContrast = 12;  // grey levels
constexpr double kMostMisfit = 0.34;
constexpr double kFarthest = 0.6;  // from the guess, in half windows
constexpr double kMostSigmaPx = 0.3;
// Where a bend is, its blur tells; that pictures are not blurred quite like a Gaussian counts as noise of
// this part of the contrast. A saddle's symmetry is not taken in.
constexpr double kBendUnlike = 0.02;
constexpr double kMostTurnRad = 35 * std::numbers::pi / 180;
constexpr double kMostBlurPx = 2.5;

constexpr double kRoughRadiusPx = 10;

using Vector = CornerShape::Vector;
using Matrix = Eigen::Matrix<double, CornerShape::kCount, CornerShape::kCount>;

bool is_saddle(DarkQuarters dark) {
  return ChartCorner{{}, dark, 0}.is_saddle();
}

/// How a shape agrees with a window: half the gradient and Hessian (Gauss and Newton's) of the squares.
struct Agreement {
  Matrix normal = Matrix::Zero();
  Vector gradient = Vector::Zero();
  double squares = 0;
  int pixels = 0;
};

Agreement agreement(const CornerWindow& window, const CornerShape& shape, DarkQuarters dark) {
  const CornerPattern pattern(shape, dark);
  Agreement sum;
  for (const auto& pixel : window.pixels) {
    const auto modelled = pattern.at(pixel.place_px);
    if (pixel.grey > kClipped && modelled.grey > kClipped) continue;  // the true level is unknown
    const double error = modelled.grey - pixel.grey;
    sum.normal.noalias() += modelled.gradient * modelled.gradient.transpose();
    sum.gradient += error * modelled.gradient;
    sum.squares += error * error;
    ++sum.pixels;
  }
  return sum;
}

/// Light and contrast that suit the window best, the rest of the shape being as it is.
CornerShape with_levels(CornerShape shape, const CornerWindow& window, DarkQuarters dark) {
  const CornerPattern pattern(shape, dark);
  double n = 0, d = 0, dd = 0, g = 0, dg = 0;
  for (const auto& pixel : window.pixels) {
    const double darkness = pattern.at(pixel.place_px).darkness;
    n += 1, d += darkness, dd += darkness * darkness, g += pixel.grey, dg += darkness * pixel.grey;
  }
  shape.contrast = (d * g - n * dg) / (n * dd - d * d);
  shape.light = (g + shape.contrast * d) / n;
  return shape;
}

struct Fit {
  CornerShape shape;
  Agreement agreement;
};

/// The shape that suits the window best; near enough when a step lessens the squares by less than this part
/// of a pixel's share.
Fit fitted(const CornerWindow& window, const CornerShape& start, DarkQuarters dark, double enough) {
  constexpr int kMostRounds = 30;
  Fit best{start, agreement(window, start, dark)};
  double damping = 1e-2;
  for (int round = 0; round < kMostRounds && damping < 1e6; ++round) {
    Matrix damped = best.agreement.normal;
    damped.diagonal() *= 1 + damping;
    const Vector step = -damped.ldlt().solve(best.agreement.gradient);
    if (!step.allFinite()) break;
    const CornerShape tried = best.shape.moved(step);
    const Agreement now = agreement(window, tried, dark);
    const bool better = now.squares < best.agreement.squares;
    damping *= better ? 0.1 : 10;
    if (!better) continue;
    const double gain = best.agreement.squares - now.squares;
    best = {tried, now};
    if (gain * now.pixels < enough * now.squares) break;
  }
  return best;
}

/// Of the normal on an edge, towards the side that `to` points to.
double normal_rad(const Eigen::Vector2d& edge, const Eigen::Vector2d& to) {
  const Eigen::Vector2d left(-edge.y(), edge.x());
  const Eigen::Vector2d normal = left.dot(to) > 0 ? left : Eigen::Vector2d(-left);
  return std::atan2(normal.y(), normal.x());
}

Eigen::Vector2d turned(const Eigen::Vector2d& v, double angle_rad) {
  const double c = std::cos(angle_rad), s = std::sin(angle_rad);
  return {c * v.x() - s * v.y(), s * v.x() + c * v.y()};
}

/// Half a window, or how far it goes along the shorter edge.
double half_window_px(const CornerGuess& guess) {
  return std::min(kWindowRadiusPx, kWindowShare * std::min(guess.along_x_px.norm(), guess.along_y_px.norm()));
}

CornerShape first_shape(const CornerGuess& guess) {
  CornerShape shape;
  shape.normals_rad = {normal_rad(guess.along_y_px, guess.along_x_px),
                       normal_rad(guess.along_x_px, guess.along_y_px)};
  shape.log_blur = std::log(std::clamp(half_window_px(guess) / 3, 0.7, 2.0));
  return shape;
}

struct Found {
  Fit fit;
  Eigen::Vector2d pixel;
};

/// Fits twice: roughly in a small window, then about the place and along the edges that were found.
std::optional<Found> find(const cv::Mat& grey, const geometry::Lens& lens, const CornerGuess& guess) {
  CornerShape shape = first_shape(guess);
  const Eigen::Vector2d expected_rad = shape.normals_rad;
  const double farthest_px = kFarthest * half_window_px(guess);
  CornerGuess now = guess;
  Fit fit;
  for (const auto& [radius_px, enough] : {std::pair(kRoughRadiusPx, 1.0), std::pair(kWindowRadiusPx, 0.01)}) {
    const auto window = corner_window(grey, lens, now, radius_px);
    if (!window) return std::nullopt;
    shape.corner_px = {0, 0};
    shape = with_levels(shape, *window, guess.dark);
    if (!(shape.contrast > 0)) return std::nullopt;
    fit = fitted(*window, shape, guess.dark, enough);
    shape = fit.shape;
    const Eigen::Vector2d turn_rad = shape.normals_rad - expected_rad;
    if (!(turn_rad.cwiseAbs().maxCoeff() < kMostTurnRad)) return std::nullopt;
    const auto pixel = lens.project(window->ray_at(shape.corner_px));
    if (!pixel || !((*pixel - guess.pixel).norm() < farthest_px)) return std::nullopt;
    now.pixel = *pixel;
    now.along_x_px = turned(guess.along_x_px, turn_rad.y());
    now.along_y_px = turned(guess.along_y_px, turn_rad.x());
  }
  return Found{fit, now.pixel};
}

}  // namespace

std::optional<FittedCorner> fit_corner(const cv::Mat& grey, const geometry::Lens& lens,
                                       const CornerGuess& guess) {
  if (!CornerPattern::is_corner(guess.dark)) return std::nullopt;
  const auto found = find(grey, lens, guess);
  if (!found) return std::nullopt;
  const CornerShape& shape = found->fit.shape;
  const Agreement& agreement = found->fit.agreement;
  const int freedom = agreement.pixels - CornerShape::kCount;
  if (!(shape.contrast > kLeastContrast && shape.blur_px() < kMostBlurPx && freedom > 0)) {
    return std::nullopt;
  }
  FittedCorner corner;
  corner.pixel = found->pixel;
  corner.contrast = shape.contrast;
  corner.misfit = std::sqrt(agreement.squares / freedom) / shape.contrast;
  if (!(corner.misfit < kMostMisfit)) return std::nullopt;
  const double unlike = is_saddle(guess.dark) ? 0 : kBendUnlike;
  const double variance = std::pow(shape.contrast, 2) * (std::pow(corner.misfit, 2) + std::pow(unlike, 2));
  const Matrix inverse = agreement.normal.ldlt().solve(Matrix::Identity());
  corner.covariance_px2 = variance * inverse.topLeftCorner<2, 2>();
  if (!(corner.covariance_px2.trace() < kMostSigmaPx * kMostSigmaPx)) return std::nullopt;
  return corner;
}

}  // namespace svchain::calibration
