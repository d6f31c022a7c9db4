#include "algorithms/geometry/monotone_curve.h"

#include <algorithm>
#include <cmath>

#include "algorithms/geometry/monotone_root.h"

namespace svchain::geometry {

namespace {

/// Index of the piece between two nodes that holds `value`.
size_t piece_of(const std::vector<double>& nodes, double value) {
  const auto above = std::upper_bound(nodes.begin() + 1, nodes.end() - 1, value);
  return static_cast<size_t>(above - nodes.begin()) - 1;
}

/// Slopes at the nodes, cut down until no piece between them overshoots.
std::vector<double> monotone_slopes(const std::vector<double>& x, const std::vector<double>& y) {
  const size_t pieces = x.size() - 1;
  const auto width = [&](size_t i) { return x[i + 1] - x[i]; };
  const auto secant = [&](size_t i) { return (y[i + 1] - y[i]) / width(i); };

  std::vector<double> slope(x.size());
  slope.front() = secant(0);
  slope.back() = secant(pieces - 1);
  for (size_t i = 1; i < pieces; ++i) {
    slope[i] = (width(i) * secant(i - 1) + width(i - 1) * secant(i)) / (width(i - 1) + width(i));
  }
  for (size_t i = 0; i < pieces; ++i) {
    const double steepest = std::hypot(slope[i], slope[i + 1]) / (3 * secant(i));
    if (steepest <= 1) continue;
    slope[i] /= steepest;
    slope[i + 1] /= steepest;
  }
  return slope;
}

}  // namespace

MonotoneCurve::MonotoneCurve(std::vector<double> x, std::vector<double> y)
    : x_(std::move(x)), y_(std::move(y)), slope_(monotone_slopes(x_, y_)) {}

double MonotoneCurve::in_piece(size_t i, double x) const {
  const double width = x_[i + 1] - x_[i];
  const double s = (x - x_[i]) / width;
  const double rise = y_[i + 1] - y_[i];
  const double from = slope_[i] * width;
  const double to = slope_[i + 1] * width;
  return y_[i] + s * (from + s * (3 * rise - 2 * from - to + s * (from + to - 2 * rise)));
}

double MonotoneCurve::slope_in_piece(size_t i, double x) const {
  const double width = x_[i + 1] - x_[i];
  const double s = (x - x_[i]) / width;
  const double rise = y_[i + 1] - y_[i];
  const double from = slope_[i] * width;
  const double to = slope_[i + 1] * width;
  return (from + s * (2 * (3 * rise - 2 * from - to) + 3 * s * (from + to - 2 * rise))) / width;
}

double MonotoneCurve::at(double x) const {
  x = std::clamp(x, x_.front(), x_.back());
  return in_piece(piece_of(x_, x), x);
}

double MonotoneCurve::inverse(double y) const {
  y = std::clamp(y, y_.front(), y_.back());
  const size_t i = piece_of(y_, y);
  const double start = x_[i] + (y - y_[i]) / (y_[i + 1] - y_[i]) * (x_[i + 1] - x_[i]);
  return monotone_root([&](double x) { return in_piece(i, x); },
                       [&](double x) { return slope_in_piece(i, x); }, y, x_[i], x_[i + 1], start);
}

}  // namespace svchain::geometry
