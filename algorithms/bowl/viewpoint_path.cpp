#include "algorithms/bowl/viewpoint_path.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "algorithms/bowl/viewpoint_presets.h"

namespace svchain::bowl {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;
enum { kRadius, kAngle, kHeight, kTarget, kUp = kTarget + 3, kFieldOfView = kUp + 3 };

/// Radial, in the sense of the turn, and upwards: the columns.
Eigen::Matrix3d axes_at(double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  Eigen::Matrix3d axes;
  axes << c, -s, 0, s, c, 0, 0, 0, 1;
  return axes;
}

/// Behind the way the picture's upper edge shows, for an eye that is above its target and has no angle.
double angle_of(const Viewpoint& viewpoint) {
  const Eigen::Vector3d& eye = viewpoint.eye_m;
  const double radius = eye.head<2>().norm();
  const Eigen::Vector2d up = viewpoint.up.head<2>();
  if (radius > 1e-3 * std::abs(eye.z()) || up.norm() < 1e-9) return std::atan2(eye.y(), eye.x());
  return std::atan2(-up.y(), -up.x());
}

ViewpointCoordinates coordinates(const Viewpoint& viewpoint) {
  ViewpointCoordinates place;
  const double angle = angle_of(viewpoint);
  place << viewpoint.eye_m.head<2>().norm(), angle, viewpoint.eye_m.z(), viewpoint.target_m,
      axes_at(angle).transpose() * viewpoint.up.normalized(), viewpoint.field_of_view_deg;
  return place;
}

Viewpoint viewpoint_at(const ViewpointCoordinates& place) {
  const Eigen::Matrix3d axes = axes_at(place[kAngle]);
  Viewpoint viewpoint;
  viewpoint.eye_m = axes * Eigen::Vector3d(place[kRadius], 0, place[kHeight]);
  viewpoint.target_m = place.segment<3>(kTarget);
  viewpoint.up = axes * place.segment<3>(kUp).normalized();
  viewpoint.field_of_view_deg = place[kFieldOfView];
  return viewpoint;
}

/// The same place, its angle within half a turn of the other's; exactly half is gone counter-clockwise.
ViewpointCoordinates turned_next_to(ViewpointCoordinates place, const ViewpointCoordinates& other) {
  double turn = std::remainder(place[kAngle] - other[kAngle], kTurn);
  if (turn < -kTurn / 2 + 1e-9) turn += kTurn;
  place[kAngle] = other[kAngle] + turn;
  return place;
}

double harmonic_mean(double a, double b) {
  return a * b > 0 ? 2 * a * b / (a + b) : 0;
}

}  // namespace

Viewpoint mixed(const Viewpoint& a, const Viewpoint& b, double t) {
  const ViewpointCoordinates from = coordinates(a);
  const ViewpointCoordinates to = turned_next_to(coordinates(b), from);
  return viewpoint_at((1 - t) * from + t * to);
}

ViewpointPath::ViewpointPath(const std::vector<KeyFrame>& key_frames, bool loop) : loop_(loop) {
  if (key_frames.size() < (loop ? 2u : 1u))
    throw std::invalid_argument("viewpoint path: too few key frames, expected one, or two of a loop");
  for (const KeyFrame& frame : key_frames) {
    if (!std::isfinite(frame.time_s) || (!times_.empty() && !(frame.time_s > times_.back())))
      throw std::invalid_argument("viewpoint path: the times of key frames do not rise");
    const ViewpointCoordinates place = coordinates(frame.viewpoint);
    times_.push_back(frame.time_s);
    places_.push_back(places_.empty() ? place : turned_next_to(place, places_.back()));
  }
  if (loop && !(key_frames.front().viewpoint == key_frames.back().viewpoint))
    throw std::invalid_argument("viewpoint path: a loop that does not end where it begins");
  choose_slopes();
}

void ViewpointPath::choose_slopes() {
  std::vector<ViewpointCoordinates> chords;
  for (size_t i = 0; i + 1 < places_.size(); ++i)
    chords.emplace_back((places_[i + 1] - places_[i]) / (times_[i + 1] - times_[i]));
  slopes_.assign(places_.size(), ViewpointCoordinates::Zero());
  for (size_t i = 1; i < chords.size(); ++i) slopes_[i] = chords[i - 1].binaryExpr(chords[i], &harmonic_mean);
  if (loop_) slopes_.front() = slopes_.back() = chords.back().binaryExpr(chords.front(), &harmonic_mean);
}

Viewpoint ViewpointPath::at(double time_s) const {
  const double length = end_s() - begin_s();
  double time = std::clamp(time_s, begin_s(), end_s());
  if (loop_) time = time_s - length * std::floor((time_s - begin_s()) / length);
  const auto after = std::upper_bound(times_.begin(), times_.end(), time);
  if (after == times_.begin()) return viewpoint_at(places_.front());
  if (after == times_.end()) return viewpoint_at(places_.back());
  const size_t i = after - times_.begin() - 1;
  const double span = times_[i + 1] - times_[i];
  const double t = (time - times_[i]) / span;
  const double risen = t * t * (3 - 2 * t);  // Hermite's four polynomials, the first being 1 - risen
  return viewpoint_at((1 - risen) * places_[i] + risen * places_[i + 1] +
                      span * t * (1 - t) * ((1 - t) * slopes_[i] - t * slopes_[i + 1]));
}

ViewpointPath orbit(const geometry::Vehicle& vehicle, const BowlSurface& surface) {
  constexpr int kStops = 12;
  constexpr double kSecondsAStop = 1;
  const Viewpoint chase = *preset("chase", vehicle, surface);
  std::vector<KeyFrame> frames;
  for (int i = 0; i <= kStops; ++i) {
    Viewpoint stop = chase;
    const Eigen::Matrix3d turn = axes_at(kTurn * (i % kStops) / kStops);
    stop.eye_m = turn * chase.eye_m;
    stop.target_m = turn * chase.target_m;
    frames.push_back({i * kSecondsAStop, inside_bowl(stop, surface)});
  }
  return {frames, true};
}

}  // namespace svchain::bowl
