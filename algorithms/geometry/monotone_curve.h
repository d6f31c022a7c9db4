#pragma once
// A rising curve through given nodes and its inverse: piecewise cubic, continuous slope, never overshooting
// (Fritsch and Carlson, SIAM J. Numer. Anal. 17(2), 1980; node slopes by the parabola through three
// neighbours). Immutable.

#include <cstddef>
#include <vector>

namespace svchain::geometry {

class MonotoneCurve {
 public:
  /// At least two nodes, x and y both strictly rising.
  MonotoneCurve(std::vector<double> x, std::vector<double> y);

  /// y at an x between the first and the last node; outside, the end's value.
  double at(double x) const;
  /// The x of a y between the first and the last node; outside, the end's x.
  double inverse(double y) const;

  double last_x() const { return x_.back(); }
  double last_y() const { return y_.back(); }

 private:
  double in_piece(size_t piece, double x) const;
  double slope_in_piece(size_t piece, double x) const;

  std::vector<double> x_;
  std::vector<double> y_;
  std::vector<double> slope_;
};

}  // namespace svchain::geometry
