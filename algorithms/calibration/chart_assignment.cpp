#include "algorithms/calibration/chart_assignment.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace svchain::calibration {

namespace {

using Eigen::Vector2d;
using geometry::Pose2;

constexpr double kMostTurnRad = 0.6;  // a quarter turn, or half of it, is another identity
constexpr double kTie = 2.5;          // scores that differ by less leave the choice to the place
constexpr double kSamePiece = 0.5;    // of a side: pieces of one chart in one picture agree so well

/// Where the identity puts its chart, as the camera sees it.
Pose2 chart_pose(const Fragment& fragment, const Pose2& vehicle_from_fragment, const Identity& identity,
                 const ChartPattern& pattern) {
  std::vector<Vector2d> from, to;
  for (size_t i = 0; i < fragment.corners.size(); ++i) {
    if (identity.corner[i] < 0) continue;
    from.push_back(pattern.corners[static_cast<size_t>(identity.corner[i])].place_m);
    to.push_back(vehicle_from_fragment * fragment.corners[i].place_m);
  }
  return pose_between(from, to);
}

/// Middle of the corners that an identity explains, in the vehicle's frame, by the chart's pose.
Vector2d middle(const Identity& identity, const ChartPattern& pattern, const Pose2& vehicle_from_chart) {
  Vector2d sum = Vector2d::Zero();
  int count = 0;
  for (const int corner : identity.corner) {
    if (corner < 0) continue;
    sum += vehicle_from_chart * pattern.corners[static_cast<size_t>(corner)].place_m;
    ++count;
  }
  return sum / std::max(count, 1);
}

/// A fragment of one camera with one of its identities.
struct Claim {
  size_t camera = 0;
  size_t fragment = 0;
  Identity identity;
  Pose2 vehicle_from_chart;
};

double turn(const Pose2& a, const Pose2& b) {
  return std::abs(std::remainder(a.yaw_rad - b.yaw_rad, 2 * M_PI));
}

double distance_m(const Pose2& a, const Pose2& b) {
  return std::hypot(a.x_m - b.x_m, a.y_m - b.y_m);
}

bool overlap(const Identity& a, const Identity& b) {
  return a.chart == b.chart && std::any_of(a.corner.begin(), a.corner.end(), [&](int corner) {
           return corner >= 0 && std::find(b.corner.begin(), b.corner.end(), corner) != b.corner.end();
         });
}

/// Rises clockwise around the vehicle, from between its left side and its rear left corner on.
double clockwise_from_left(const Claim& claim) {
  constexpr double kStartRad = 2.1;
  const double around = std::atan2(claim.vehicle_from_chart.y_m, claim.vehicle_from_chart.x_m);
  return std::fmod(kStartRad - around + 4 * M_PI, 2 * M_PI);
}

class Assignment {
 public:
  Assignment(const std::vector<Levelled>& cameras, const std::vector<ChartPattern>& patterns,
             const PoseSigma& sigma, double reach_m)
      : cameras_(cameras), patterns_(patterns), sigma_(sigma), reach_m_(reach_m) {
    made_.named.resize(cameras.size());
    made_.contradictions.assign(cameras.size(), 0);
    for (const auto& pattern : patterns) made_.vehicle_from_chart.push_back(pattern.chart.vehicle_from_chart);
  }

  ChartAssignment make() {
    std::vector<std::vector<Claim>> unposed;
    for (size_t c = 0; c < cameras_.size(); ++c) {
      const Pose2 motion = motion_of(c);
      for (size_t f = 0; f < cameras_[c].fragments.size(); ++f) {
        auto all = claims(c, f);
        if (all.empty()) continue;
        if (const Claim* posed = nearest_posed(all, motion))
          name(*posed);
        else if (!patterns_[all.front().identity.chart].chart.vehicle_from_chart)
          unposed.push_back(std::move(all));
        else
          ++made_.contradictions[c];
      }
    }
    auto found = clusters(unposed);
    // Where there are more than charts, what several cameras see counts more.
    std::stable_sort(found.begin(), found.end(),
                     [](const auto& a, const auto& b) { return a.size() > b.size(); });
    keep_as_many_as_charts(found);
    std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) {
      return clockwise_from_left(a.front()) < clockwise_from_left(b.front());
    });
    for (auto& cluster : found) place(cluster);
    return std::move(made_);
  }

 private:
  /// Identities about as good as the best, the one whose x axis points most nearly forward first.
  std::vector<Claim> claims(size_t camera, size_t fragment) const {
    const Levelled& levelled = cameras_[camera];
    const Fragment& piece = levelled.fragments[fragment];
    std::vector<Claim> made;
    double best = 0;
    for (auto& identity : identities(piece, patterns_)) {
      best = std::max(best, identity.score);
      if (identity.score < best - kTie) break;
      const ChartPattern& pattern = patterns_[identity.chart];
      const Pose2 pose = chart_pose(piece, levelled.vehicle_from_fragment[fragment], identity, pattern);
      made.push_back({camera, fragment, std::move(identity), pose});
    }
    std::stable_sort(made.begin(), made.end(), [](const Claim& a, const Claim& b) {
      if (a.identity.score != b.identity.score) return a.identity.score > b.identity.score;
      return turn(a.vehicle_from_chart, {}) < turn(b.vehicle_from_chart, {});
    });
    return made;
  }

  /// What is left of a camera's pose, a common motion on the ground, by its pieces of posed charts: each of a
  /// piece's identities would mean one, and right is the one that asks least of the camera and fits the most
  /// pieces.
  Pose2 motion_of(size_t camera) const {
    std::vector<std::vector<Claim>> pieces;
    for (size_t f = 0; f < cameras_[camera].fragments.size(); ++f) pieces.push_back(claims(camera, f));
    Pose2 best;
    double least = std::numeric_limits<double>::infinity();
    for (const auto& all : pieces) {
      for (const auto& claim : all) {
        const auto motion = motion_by(claim);
        if (!motion) continue;
        const double cost = cost_of(*motion, camera, pieces);
        if (cost >= least) continue;
        least = cost;
        best = *motion;
      }
    }
    return best;
  }

  std::optional<Pose2> motion_by(const Claim& claim) const {
    const auto& pattern = patterns_[claim.identity.chart];
    if (!pattern.chart.vehicle_from_chart) return std::nullopt;
    std::vector<Vector2d> from, to;
    for (const int corner : claim.identity.corner) {
      if (corner < 0) continue;
      const Vector2d place_m = pattern.corners[static_cast<size_t>(corner)].place_m;
      from.push_back(claim.vehicle_from_chart * place_m);
      to.push_back(*pattern.chart.vehicle_from_chart * place_m);
    }
    return pose_between(from, to);
  }

  /// In squares of sigmas of the pose; a piece that fits not at all costs as much as two of them.
  double cost_of(const Pose2& motion, size_t camera, const std::vector<std::vector<Claim>>& pieces) const {
    constexpr double kMisfit = 4;
    const Vector2d place = cameras_[camera].vehicle_from_camera.translation.head<2>();
    const double turned = std::remainder(motion.yaw_rad, 2 * M_PI) / sigma_.rad;
    const double shifted = (motion * place - place).norm() / sigma_.m;
    double cost = turned * turned + shifted * shifted;
    for (const auto& all : pieces) {
      double nearest_m = sigma_.m;
      for (const auto& claim : all) {
        const auto& pattern = patterns_[claim.identity.chart];
        if (!pattern.chart.vehicle_from_chart) continue;
        nearest_m = std::min(nearest_m, (middle(claim.identity, pattern, *pattern.chart.vehicle_from_chart) -
                                         motion * middle(claim.identity, pattern, claim.vehicle_from_chart))
                                            .norm());
      }
      cost += kMisfit * nearest_m / sigma_.m;
    }
    return cost;
  }

  /// The claim on a posed chart that lies nearest to its place, all moved by the motion.
  const Claim* nearest_posed(const std::vector<Claim>& all, const Pose2& motion) const {
    const Claim* best = nullptr;
    double best_m = reach_m_;
    for (const auto& claim : all) {
      const auto& pattern = patterns_[claim.identity.chart];
      if (!pattern.chart.vehicle_from_chart) continue;
      const Pose2& pose = *pattern.chart.vehicle_from_chart;
      if (turn(pose, claim.vehicle_from_chart) > kMostTurnRad) continue;
      const double away_m = (middle(claim.identity, pattern, pose) -
                             motion * middle(claim.identity, pattern, claim.vehicle_from_chart))
                                .norm();
      if (away_m >= best_m) continue;
      best = &claim;
      best_m = away_m;
    }
    return best;
  }

  void name(const Claim& claim) {
    auto& named = made_.named[claim.camera];
    const Fragment& fragment = cameras_[claim.camera].fragments[claim.fragment];
    for (size_t i = 0; i < fragment.corners.size(); ++i) {
      const int corner = claim.identity.corner[i];
      const bool taken = std::any_of(named.begin(), named.end(), [&](const NamedCorner& other) {
        return other.chart == claim.identity.chart && other.corner == corner;
      });
      if (corner < 0 || taken) continue;
      const auto& seen = fragment.corners[i];
      named.push_back({claim.identity.chart, corner, seen.pixel, seen.covariance_px2});
    }
  }

  /// Fragments that are the same thing on the ground; of each, the claim that agrees best with the others.
  std::vector<std::vector<Claim>> clusters(const std::vector<std::vector<Claim>>& fragments) const {
    std::vector<std::vector<Claim>> found;
    for (const auto& claims : fragments) {
      std::vector<Claim>* nearest = nullptr;
      const Claim* chosen = &claims.front();
      double nearest_m = reach_m_;
      for (auto& cluster : found) {
        for (const auto& claim : claims) {
          const double away_m = apart_m(claim, cluster);
          if (away_m >= nearest_m) continue;
          nearest = &cluster;
          chosen = &claim;
          nearest_m = away_m;
        }
      }
      if (nearest)
        nearest->push_back(*chosen);
      else
        found.push_back({*chosen});
    }
    return found;
  }

  void keep_as_many_as_charts(std::vector<std::vector<Claim>>& clusters) const {
    std::vector<size_t> taken(patterns_.size(), 0);
    std::erase_if(clusters, [&](const std::vector<Claim>& cluster) {
      const size_t chart = cluster.front().identity.chart;
      size_t like = 0, first = patterns_.size();
      for (size_t k = 0; k < patterns_.size(); ++k) {
        if (made_.vehicle_from_chart[k] || !same_pattern(chart, k)) continue;
        first = std::min(first, k);
        ++like;
      }
      return first == patterns_.size() || ++taken[first] > like;
    });
  }

  /// Greatest distance between the charts claimed; infinite where a claim cannot belong to a cluster.
  double apart_m(const Claim& claim, const std::vector<Claim>& cluster) const {
    double most_m = 0;
    for (const auto& other : cluster) {
      const double away_m = distance_m(claim.vehicle_from_chart, other.vehicle_from_chart);
      const double side_m = patterns_[claim.identity.chart].chart.side_m;
      // One camera sees a chart once, though maybe in pieces.
      const bool another = other.camera == claim.camera &&
                           (away_m > kSamePiece * side_m || overlap(claim.identity, other.identity));
      if (another || !same_pattern(other.identity.chart, claim.identity.chart) ||
          turn(claim.vehicle_from_chart, other.vehicle_from_chart) > kMostTurnRad)
        return std::numeric_limits<double>::infinity();
      most_m = std::max(most_m, away_m);
    }
    return most_m;
  }

  bool same_pattern(size_t a, size_t b) const {
    if (a == b) return true;
    const auto& one = patterns_[a].corners;
    const auto& two = patterns_[b].corners;
    if (patterns_[a].chart.type == ChartType::kAprilTag36h11) return false;
    return one.size() == two.size() &&
           std::equal(one.begin(), one.end(), two.begin(), [](const ChartCorner& x, const ChartCorner& y) {
             return x.place_m.isApprox(y.place_m) && x.dark == y.dark;
           });
  }

  /// The first chart of this pattern that has not been placed.
  std::optional<size_t> free_chart_like(size_t chart) const {
    for (size_t k = 0; k < patterns_.size(); ++k) {
      if (!made_.vehicle_from_chart[k] && same_pattern(chart, k)) return k;
    }
    return std::nullopt;
  }

  void place(std::vector<Claim>& cluster) {
    const auto chart = free_chart_like(cluster.front().identity.chart);
    if (!chart) return;
    Pose2 mean;
    const double share = 1.0 / static_cast<double>(cluster.size());
    const double yaw_rad = cluster.front().vehicle_from_chart.yaw_rad;
    mean.yaw_rad = yaw_rad;
    for (auto& claim : cluster) {
      claim.identity.chart = *chart;
      mean.x_m += share * claim.vehicle_from_chart.x_m;
      mean.y_m += share * claim.vehicle_from_chart.y_m;
      mean.yaw_rad += share * std::remainder(claim.vehicle_from_chart.yaw_rad - yaw_rad, 2 * M_PI);
    }
    made_.vehicle_from_chart[*chart] = mean;
    for (const auto& claim : cluster) name(claim);
  }

  const std::vector<Levelled>& cameras_;
  const std::vector<ChartPattern>& patterns_;
  PoseSigma sigma_;
  double reach_m_;
  ChartAssignment made_;
};

}  // namespace

ChartAssignment assign_charts(const std::vector<Levelled>& cameras, const std::vector<ChartPattern>& patterns,
                              const PoseSigma& sigma, double reach_m) {
  return Assignment(cameras, patterns, sigma, reach_m).make();
}

}  // namespace svchain::calibration
