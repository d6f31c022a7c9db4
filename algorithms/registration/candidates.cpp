#include "algorithms/registration/candidates.h"

#include <Eigen/LU>
#include <algorithm>

namespace svchain::registration {

namespace {

constexpr double kReach = 3;            // standard deviations
constexpr double kMostDistance = 0.35;  // of descriptors; 0.5 is chance

struct Likeness {
  double distance = 0;
  size_t corner = 0;

  bool operator<(const Likeness& other) const {
    return distance != other.distance ? distance < other.distance : corner < other.corner;
  }
};

using Ranking = std::vector<Likeness>;

void keep_most_alike(Ranking& ranking, size_t most) {
  std::sort(ranking.begin(), ranking.end());
  if (ranking.size() > most) ranking.resize(most);
}

}  // namespace

std::vector<Candidate> candidates(const Corners& a, const Corners& b,
                                  const std::vector<Eigen::Matrix2d>& windows, size_t alternatives) {
  std::vector<Ranking> of_a(a.grounds.size()), of_b(b.grounds.size());
  for (size_t i = 0; i < a.grounds.size(); ++i) {
    const Eigen::Matrix2d information = windows[i].inverse();
    for (size_t k = 0; k < b.grounds.size(); ++k) {
      const Eigen::Vector2d apart = b.grounds[k] - a.grounds[i];
      if (apart.dot(information * apart) > kReach * kReach) continue;
      const double unlike = distance(a.descriptors[i], b.descriptors[k]);
      if (unlike > kMostDistance) continue;
      of_a[i].push_back({unlike, k});
      of_b[k].push_back({unlike, i});
    }
  }
  for (auto& ranking : of_a) keep_most_alike(ranking, alternatives);
  for (auto& ranking : of_b) keep_most_alike(ranking, alternatives);
  std::vector<Candidate> found;
  for (size_t i = 0; i < of_a.size(); ++i) {
    for (const auto& likeness : of_a[i]) {
      const Ranking& back = of_b[likeness.corner];
      const bool mutual =
          std::any_of(back.begin(), back.end(), [&](const Likeness& other) { return other.corner == i; });
      if (mutual) found.push_back({i, likeness.corner});
    }
  }
  return found;
}

}  // namespace svchain::registration
