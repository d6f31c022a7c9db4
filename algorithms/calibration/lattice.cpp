#include "algorithms/calibration/lattice.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

namespace svchain::calibration {

namespace {

using Eigen::Vector2d;
using Eigen::Vector2i;

constexpr double kNear = 0.3;       // of a side: how far a neighbour may be from where it is expected
constexpr double kTurnedRad = 0.5;  // how far its axis may be turned
constexpr size_t kLeastNodes = 4;

const std::array<Vector2i, 4> kSteps = {Vector2i(1, 0), Vector2i(0, 1), Vector2i(-1, 0), Vector2i(0, -1)};

/// Angle between two axes, 0 to pi / 2.
double between_axes(double a, double b) {
  return std::abs(std::remainder(a - b, std::numbers::pi));
}

/// Grows one piece of lattice from a saddle.
class Growth {
 public:
  Growth(const std::vector<SaddlePoint>& saddles, std::vector<bool>& taken, double side_m)
      : saddles_(saddles), taken_(taken), side_m_(side_m) {}

  Lattice from(size_t seed) {
    const double edge = saddles_[seed].dark_axis_rad - std::numbers::pi / 4;
    const Vector2d x = side_m_ * Vector2d(std::cos(edge), std::sin(edge));
    add(seed, {{0, 0}, saddles_[seed].ground_m, x, {-x.y(), x.x()}, true});
    for (size_t next = 0; next < nodes_.size(); ++next) {
      for (const Vector2i& step : kSteps) grow(next, step);
    }
    return std::move(nodes_);
  }

 private:
  void add(size_t saddle, const LatticeNode& node) {
    taken_[saddle] = true;
    at_[{node.place.x(), node.place.y()}] = nodes_.size();
    nodes_.push_back(node);
    axes_.push_back(saddles_[saddle].dark_axis_rad);
  }

  const LatticeNode* node_at(const Vector2i& place) const {
    const auto found = at_.find({place.x(), place.y()});
    return found == at_.end() ? nullptr : &nodes_[found->second];
  }

  void grow(size_t from, const Vector2i& step) {
    const LatticeNode node = nodes_[from];
    const Vector2i place = node.place + step;
    if (node_at(place)) return;
    Vector2d way = step.x() * node.along_x_m + step.y() * node.along_y_m;
    if (const LatticeNode* behind = node_at(node.place - step)) way = node.ground_m - behind->ground_m;
    const auto found = nearest(node.ground_m + way, axes_[from] + std::numbers::pi / 2);
    if (found == saddles_.size()) return;
    LatticeNode next{place, saddles_[found].ground_m, node.along_x_m, node.along_y_m, !node.dark_diagonal};
    (step.x() != 0 ? next.along_x_m : next.along_y_m) =
        (next.ground_m - node.ground_m) * (step.x() + step.y());
    add(found, next);
  }

  /// The nearest free saddle to a place whose dark axis is as expected; the number of saddles if there is
  /// none.
  size_t nearest(const Vector2d& ground_m, double dark_axis_rad) const {
    size_t best = saddles_.size();
    double best_m = kNear * side_m_;
    for (size_t s = 0; s < saddles_.size(); ++s) {
      if (taken_[s] || between_axes(saddles_[s].dark_axis_rad, dark_axis_rad) > kTurnedRad) continue;
      const double away_m = (saddles_[s].ground_m - ground_m).norm();
      if (away_m >= best_m) continue;
      best = s;
      best_m = away_m;
    }
    return best;
  }

  const std::vector<SaddlePoint>& saddles_;
  std::vector<bool>& taken_;
  double side_m_;
  Lattice nodes_;
  std::vector<double> axes_;
  std::map<std::pair<int, int>, size_t> at_;
};

bool is_flat(const Lattice& lattice) {
  Vector2i least = lattice.front().place, most = least;
  for (const auto& node : lattice) {
    least = least.cwiseMin(node.place);
    most = most.cwiseMax(node.place);
  }
  return (most - least).minCoeff() >= 1;
}

}  // namespace

std::vector<Lattice> find_lattices(const std::vector<SaddlePoint>& saddles, double side_m) {
  std::vector<bool> taken(saddles.size(), false);
  std::vector<Lattice> found;
  for (size_t seed = 0; seed < saddles.size(); ++seed) {
    if (taken[seed]) continue;
    Lattice lattice = Growth(saddles, taken, side_m).from(seed);
    if (lattice.size() >= kLeastNodes && is_flat(lattice)) found.push_back(std::move(lattice));
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& a, const auto& b) { return a.size() > b.size(); });
  return found;
}

}  // namespace svchain::calibration
