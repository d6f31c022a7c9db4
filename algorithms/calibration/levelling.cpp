#include "algorithms/calibration/levelling.h"

#include <cmath>

namespace svchain::calibration {

namespace {

using Eigen::Vector2d;
using geometry::Pose2;

/// A fragment's pose by where its corners' rays meet the ground; nothing where they do not.
std::optional<Pose2> laid_down(const geometry::Camera& camera, const Fragment& fragment) {
  std::vector<Vector2d> from, to;
  for (const auto& corner : fragment.corners) {
    const auto ground = ground_of(*camera.lens, camera.vehicle_from_camera, corner.pixel);
    if (!ground) return std::nullopt;
    from.push_back(corner.place_m);
    to.push_back(*ground);
  }
  return pose_between(from, to);
}

JointProblem problem_of(const geometry::Camera& camera, const PosePrior& prior,
                        const std::vector<Fragment>& fragments) {
  JointProblem problem;
  problem.cameras.push_back({camera.vehicle_from_camera, camera.lens, prior, std::nullopt});
  for (const auto& fragment : fragments) {
    const size_t chart = problem.charts.size();
    problem.charts.push_back({laid_down(camera, fragment).value_or(Pose2()), false});
    for (const auto& corner : fragment.corners)
      problem.sightings.push_back({0, chart, corner.place_m, corner.pixel, Eigen::Matrix2d::Identity()});
  }
  return problem;
}

double rms_px(const JointProblem& problem, const JointSolution& solution) {
  constexpr double kLostPx = 100;
  double sum = 0;
  for (const auto& sighting : problem.sightings) {
    const auto off = residual_px(sighting, solution.cameras[0], solution.charts[sighting.chart]);
    sum += off ? off->squaredNorm() : kLostPx * kLostPx;
  }
  return std::sqrt(sum / static_cast<double>(problem.sightings.size()));
}

/// A flat chart of equal squares on the ground, seen from about where the camera should be. Patterns on walls
/// and clutter are not.
bool lies_on_ground(const geometry::Camera& camera, const PosePrior& prior, const Fragment& fragment) {
  constexpr double kMostPx = 4;  // leaves room for a lens that is not quite known
  constexpr double kMostSigmas = 4;
  if (!laid_down(camera, fragment)) return false;
  const JointProblem problem = problem_of(camera, prior, {fragment});
  const JointSolution solution = refine_jointly(problem);
  const geometry::Rigid3& pose = solution.cameras[0].vehicle_from_camera;
  const double turned = pose.rotation.angularDistance(prior.vehicle_from_camera.rotation);
  const double shifted = (pose.translation - prior.vehicle_from_camera.translation).norm();
  return rms_px(problem, solution) < kMostPx && turned < kMostSigmas * prior.sigma_rad &&
         shifted < kMostSigmas * prior.sigma_m;
}

}  // namespace

std::optional<Vector2d> ground_of(const geometry::Lens& lens, const geometry::Rigid3& vehicle_from_camera,
                                  const Vector2d& pixel) {
  const auto ray = lens.unproject(pixel);
  if (!ray) return std::nullopt;
  const Eigen::Vector3d down = vehicle_from_camera.rotation * *ray;
  const Eigen::Vector3d& from = vehicle_from_camera.translation;
  constexpr double kLeastSlope = 0.01;
  if (down.z() > -kLeastSlope || from.z() <= 0) return std::nullopt;
  return Vector2d((from - down * (from.z() / down.z())).head<2>());
}

Pose2 pose_between(const std::vector<Vector2d>& from, const std::vector<Vector2d>& to) {
  const auto count = static_cast<double>(from.size());
  Vector2d from_mean = Vector2d::Zero(), to_mean = Vector2d::Zero();
  for (size_t i = 0; i < from.size(); ++i) {
    from_mean += from[i] / count;
    to_mean += to[i] / count;
  }
  double cosine = 0, sine = 0;
  for (size_t i = 0; i < from.size(); ++i) {
    const Vector2d a = from[i] - from_mean, b = to[i] - to_mean;
    cosine += a.dot(b);
    sine += a.x() * b.y() - a.y() * b.x();
  }
  const Pose2 turn{0, 0, std::atan2(sine, cosine)};
  const Vector2d shift = to_mean - turn * from_mean;
  return {shift.x(), shift.y(), turn.yaw_rad};
}

Levelled level_camera(const geometry::Camera& camera, const PosePrior& prior,
                      std::vector<Fragment> fragments) {
  std::erase_if(fragments, [&](const Fragment& f) { return !lies_on_ground(camera, prior, f); });
  Levelled levelled{camera.vehicle_from_camera, std::move(fragments), {}};
  if (levelled.fragments.empty()) return levelled;
  const JointSolution solution = refine_jointly(problem_of(camera, prior, levelled.fragments));
  levelled.vehicle_from_camera = solution.cameras[0].vehicle_from_camera;
  for (const auto& chart : solution.charts)
    levelled.vehicle_from_fragment.push_back(chart.vehicle_from_chart);
  return levelled;
}

}  // namespace svchain::calibration
