#include "algorithms/calibration/identity.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace svchain::calibration {

namespace {

using Eigen::Vector2d;

constexpr double kSamePlace = 0.1;       // of a side
constexpr double kLeastExplained = 0.6;  // of a fragment's corners
constexpr double kMissing = 0.5;         // what a corner counts that the fragment passes over

Vector2d quarter_turned(const Vector2d& v, int quarters) {
  switch (quarters) {
    case 1:
      return {-v.y(), v.x()};
    case 2:
      return -v;
    case 3:
      return {v.y(), -v.x()};
    default:
      return v;
  }
}

DarkQuarters quarter_turned(DarkQuarters dark, int quarters) {
  return static_cast<DarkQuarters>((dark << quarters | dark >> (4 - quarters)) & 0b1111);
}

Fragment quarter_turned(Fragment fragment, int quarters) {
  for (auto& corner : fragment.corners) {
    corner.place_m = quarter_turned(corner.place_m, quarters);
    corner.dark = quarter_turned(corner.dark, quarters);
  }
  return fragment;
}

/// The chart's corner at a place, whatever its pattern; -1 if there is none.
int corner_at(const ChartPattern& pattern, const Vector2d& place_m) {
  const double near_m = kSamePlace * pattern.chart.side_m;
  for (size_t k = 0; k < pattern.corners.size(); ++k) {
    if ((pattern.corners[k].place_m - place_m).cwiseAbs().maxCoeff() < near_m) return static_cast<int>(k);
  }
  return -1;
}

/// Corners of the chart within the fragment's outline that show the kind of corner fragments are made of, and
/// are not among those explained.
int passed_over(const ChartPattern& pattern, const Eigen::AlignedBox2d& outline,
                const std::vector<int>& explained) {
  int missing = 0;
  for (size_t k = 0; k < pattern.corners.size(); ++k) {
    const ChartCorner& corner = pattern.corners[k];
    if (!corner.is_saddle() || !outline.contains(corner.place_m)) continue;
    missing += std::find(explained.begin(), explained.end(), static_cast<int>(k)) == explained.end();
  }
  return missing;
}

/// The fragment shifted so that its corner `anchor` lies on the chart's corner `target`.
Identity shifted(const Fragment& fragment, const ChartPattern& pattern, size_t anchor, size_t target) {
  const Vector2d shift = pattern.corners[target].place_m - fragment.corners[anchor].place_m;
  Identity identity;
  int hits = 0;
  Eigen::AlignedBox2d outline;
  for (const auto& corner : fragment.corners) {
    int at = corner_at(pattern, corner.place_m + shift);
    if (at >= 0 && pattern.corners[static_cast<size_t>(at)].dark != corner.dark) at = -1;
    identity.corner.push_back(at);
    if (at < 0) continue;
    ++hits;
    outline.extend(pattern.corners[static_cast<size_t>(at)].place_m);
  }
  const bool lattice = fragment.corners.front().dark == 0b0101 || fragment.corners.front().dark == 0b1010;
  const int missing = lattice ? passed_over(pattern, outline, identity.corner) : 0;
  identity.score = hits - kMissing * missing;
  return identity;
}

/// Both ways up: makers of tags do not agree which way up they are.
std::vector<Identity> tag_identities(const ChartPattern& pattern, size_t chart, const Fragment& fragment) {
  constexpr double kOtherWayUp = 0.5;
  const auto& tags = pattern.chart.tags;
  const auto tag =
      std::find_if(tags.begin(), tags.end(), [&](const Tag& t) { return t.id == fragment.tag_id; });
  std::vector<Identity> found;
  if (tag == tags.end()) return found;
  for (const int quarters : {0, 2}) {
    Identity identity{chart, {}, quarters == 0 ? 0 : -kOtherWayUp};
    const Fragment turned = quarter_turned(fragment, quarters);
    for (const auto& corner : turned.corners) {
      identity.corner.push_back(corner_at(pattern, tag->place_m + corner.place_m));
      identity.score += 1;
    }
    found.push_back(std::move(identity));
  }
  return found;
}

void add_shifts(const Fragment& fragment, const ChartPattern& pattern, size_t chart,
                std::vector<Identity>& found) {
  constexpr size_t kMostAnchors = 3;  // one of them is no false corner
  for (size_t anchor = 0; anchor < std::min(kMostAnchors, fragment.corners.size()); ++anchor) {
    for (size_t target = 0; target < pattern.corners.size(); ++target) {
      if (pattern.corners[target].dark != fragment.corners[anchor].dark) continue;
      Identity identity = shifted(fragment, pattern, anchor, target);
      identity.chart = chart;
      const bool known = std::any_of(found.begin(), found.end(), [&](const Identity& other) {
        return other.chart == chart && other.corner == identity.corner;
      });
      const auto corners = static_cast<double>(fragment.corners.size());
      if (!known && identity.score >= std::max(4.0, kLeastExplained * corners)) found.push_back(identity);
    }
  }
}

}  // namespace

std::vector<ChartPattern> patterns_of(const std::vector<Chart>& charts) {
  std::vector<ChartPattern> patterns;
  for (const auto& chart : charts) patterns.push_back({chart, corners(chart)});
  return patterns;
}

std::vector<Identity> identities(const Fragment& fragment, const std::vector<ChartPattern>& patterns) {
  if (const KnownCorners& known = fragment.known; !known.corner.empty())
    return {{known.chart, known.corner, static_cast<double>(known.corner.size())}};
  std::vector<Identity> found;
  for (size_t chart = 0; chart < patterns.size(); ++chart) {
    const bool tags = patterns[chart].chart.type == ChartType::kAprilTag36h11;
    if (tags != fragment.tag_id.has_value()) continue;
    if (tags) {
      for (auto& identity : tag_identities(patterns[chart], chart, fragment))
        found.push_back(std::move(identity));
      continue;
    }
    for (int quarters = 0; quarters < 4; ++quarters)
      add_shifts(quarter_turned(fragment, quarters), patterns[chart], chart, found);
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& a, const auto& b) { return a.score > b.score; });
  return found;
}

}  // namespace svchain::calibration
