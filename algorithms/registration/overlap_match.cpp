#include "algorithms/registration/overlap_match.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "algorithms/registration/candidates.h"
#include "algorithms/registration/harris.h"
#include "algorithms/registration/overlap.h"
#include "algorithms/registration/patch_alignment.h"

namespace svchain::registration {

namespace {

constexpr size_t kMostCorners = 150;  // in each picture
constexpr double kSpacingPx = 8;      // of the view
constexpr int kLeastSpacingPx = 3;    // of the picture
constexpr double kSlackPx = 3;        // of windows, beside what the covariance says
constexpr double kNoisePx = 1.5;      // of a corner's place

/// One of the two pictures of an overlap.
struct Side {
  size_t camera = 0;
  cv::Mat picture;
  std::vector<cv::Point> places;
  Corners corners;
};

struct Overlap {
  geometry::View view;
  cv::Mat seen;
  Side a, b;
};

Eigen::Vector2d ground_at(const geometry::View& view, const cv::Point& place) {
  return view.ground_from_pixel(Eigen::Vector2d(place.x, place.y));
}

RayPair rays_of(const Knowledge& knowledge, const Overlap& overlap, const Eigen::Vector2d& ground_a,
                const Eigen::Vector2d& ground_b) {
  const size_t a = overlap.a.camera, b = overlap.b.camera;
  return {a, b, knowledge.cameras[a].ray_from_ground * ground_a.homogeneous(),
          knowledge.cameras[b].ray_from_ground * ground_b.homogeneous()};
}

void find_corners(const Knowledge& knowledge, Side& side, const Overlap& overlap, StageClock& clock) {
  const double scale = knowledge.view.metres_per_px / overlap.view.metres_per_px;
  const int spacing_px = std::max(kLeastSpacingPx, static_cast<int>(std::lround(kSpacingPx * scale)));
  side.places = strongest_corners(side.picture, overlap.seen, kMostCorners, spacing_px);
  clock.spent_on("corners");
  side.corners.descriptors = describe(side.picture, overlap.seen, side.places);
  for (const auto& place : side.places) side.corners.grounds.push_back(ground_at(overlap.view, place));
  clock.spent_on("describe");
}

std::vector<Eigen::Matrix2d> windows_of(const Knowledge& knowledge, const DisagreementMeter& meter,
                                        const Overlap& overlap) {
  const PairCovariance prior = knowledge.covariance_of(overlap.a.camera, overlap.b.camera);
  const double slack_m = kSlackPx * overlap.view.metres_per_px;
  std::vector<Eigen::Matrix2d> windows;
  for (const auto& ground : overlap.a.corners.grounds) {
    const auto j = meter.measure(rays_of(knowledge, overlap, ground, ground)).jacobian;
    windows.push_back(j * prior * j.transpose() + slack_m * slack_m * Eigen::Matrix2d::Identity());
  }
  return windows;
}

std::vector<Candidate> agreed(const Knowledge& knowledge, const Overlap& overlap, size_t alternatives,
                              size_t& count, StageClock& clock) {
  const DisagreementMeter meter(knowledge.starts, knowledge.steps);
  const auto found =
      candidates(overlap.a.corners, overlap.b.corners, windows_of(knowledge, meter, overlap), alternatives);
  count = found.size();
  clock.spent_on("match");
  std::vector<LinearPair> pairs;
  for (const auto& candidate : found) {
    pairs.push_back(
        {candidate.in_a, meter.measure(rays_of(knowledge, overlap, overlap.a.corners.grounds[candidate.in_a],
                                               overlap.b.corners.grounds[candidate.in_b]))});
  }
  std::vector<Candidate> chosen;
  for (const size_t i : consensus(pairs, knowledge.covariance_of(overlap.a.camera, overlap.b.camera),
                                  kNoisePx * overlap.view.metres_per_px)) {
    chosen.push_back(found[i]);
  }
  clock.spent_on("reject");
  return chosen;
}

/// A picture with what its camera's pixels cover at a place of it.
SmearedPicture smeared_at(const Knowledge& knowledge, const Overlap& overlap, const Side& side,
                          const cv::Point& place) {
  constexpr double kStepPx = 0.1;
  const GroundCamera& camera = knowledge.cameras[side.camera];
  const auto image = [&](double x, double y) {
    const Eigen::Vector2d at(place.x + x, place.y + y);
    return camera.project(overlap.view.ground_from_pixel(at)).value_or(Eigen::Vector2d::Zero());
  };
  Eigen::Matrix2d image_from_picture;
  image_from_picture << (image(kStepPx, 0) - image(-kStepPx, 0)) / (2 * kStepPx),
      (image(0, kStepPx) - image(0, -kStepPx)) / (2 * kStepPx);
  return {side.picture, image_from_picture.inverse()};
}

/// The feature of a chosen candidate; nothing where patches are asked for and do not match.
std::optional<Feature> feature_of(const Knowledge& knowledge, const Overlap& overlap, const Candidate& chosen,
                                  bool patches) {
  const cv::Point place_a = overlap.a.places[chosen.in_a];
  const cv::Point place_b = overlap.b.places[chosen.in_b];
  Eigen::Vector2d shift(place_b.x - place_a.x, place_b.y - place_a.y);
  if (patches) {
    const auto found = aligned_patch(smeared_at(knowledge, overlap, overlap.a, place_a),
                                     smeared_at(knowledge, overlap, overlap.b, place_b), overlap.seen,
                                     place_a, place_b - place_a);
    if (!found) return std::nullopt;
    shift = *found;
  }
  const Eigen::Vector2d ground_a = ground_at(overlap.view, place_a);
  const Eigen::Vector2d ground_b =
      overlap.view.ground_from_pixel(Eigen::Vector2d(place_a.x, place_a.y) + shift);
  const auto pixel_a = knowledge.cameras[overlap.a.camera].project(ground_a);
  const auto pixel_b = knowledge.cameras[overlap.b.camera].project(ground_b);
  if (!pixel_a || !pixel_b) return std::nullopt;
  return Feature{*pixel_a, *pixel_b, rays_of(knowledge, overlap, ground_a, ground_b)};
}

}  // namespace

PairCovariance Knowledge::covariance_of(size_t a, size_t b) const {
  const auto i = static_cast<Eigen::Index>(8 * a), k = static_cast<Eigen::Index>(8 * b);
  PairCovariance pair;
  pair << covariance.block<8, 8>(i, i), covariance.block<8, 8>(i, k), covariance.block<8, 8>(k, i),
      covariance.block<8, 8>(k, k);
  return pair;
}

OverlapFeatures match_overlap(const Knowledge& knowledge, size_t a, const Fineness& fineness,
                              StageClock& clock) {
  const size_t b = next_clockwise(a);
  const GroundSight sight_a(knowledge.cameras[a], knowledge.vehicle);
  const GroundSight sight_b(knowledge.cameras[b], knowledge.vehicle);
  const auto view = overlap_of(sight_a, sight_b, knowledge.view, fineness.metres_per_px);
  if (!view) return {};
  Overlap overlap{*view, seen_by_both(sight_a, sight_b, *view), {a, {}, {}, {}}, {b, {}, {}, {}}};
  for (Side* side : {&overlap.a, &overlap.b}) {
    side->picture = ground_picture(knowledge.frames[side->camera], knowledge.cameras[side->camera], *view);
  }
  clock.spent_on("warp");
  for (Side* side : {&overlap.a, &overlap.b}) find_corners(knowledge, *side, overlap, clock);
  OverlapFeatures found;
  found.corners_a = overlap.a.places.size();
  found.corners_b = overlap.b.places.size();
  for (const auto& chosen : agreed(knowledge, overlap, fineness.alternatives, found.candidates, clock)) {
    if (auto feature = feature_of(knowledge, overlap, chosen, fineness.patches))
      found.features.push_back(*feature);
  }
  clock.spent_on("refine");
  return found;
}

}  // namespace svchain::registration
