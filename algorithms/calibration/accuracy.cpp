#include "algorithms/calibration/accuracy.h"

#include <cmath>
#include <cstdio>

#include "algorithms/calibration/levelling.h"
#include "algorithms/geometry/angles.h"
#include "algorithms/geometry/lens_parameters.h"

namespace svchain::calibration {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kCarLengthM = 4.8;
constexpr double kCmPerM = 100;

/// Root of the mean of squares.
class Rms {
 public:
  void add(double value) {
    sum_ += value * value;
    ++count_;
  }
  int count() const { return count_; }
  double value() const { return count_ > 0 ? std::sqrt(sum_ / count_) : 0; }

 private:
  double sum_ = 0;
  int count_ = 0;
};

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

std::string beyond(const std::string& what, double value, double limit, const std::string& unit) {
  return what + " is " + number(value) + " " + unit + ", expected at most " + number(limit) + " " + unit;
}

class Judge {
 public:
  Judge(const CalibrationInput& input, const FittedEstimate& fitted, const std::vector<SeenCorner>& corners,
        const std::vector<ChartPattern>& patterns, const AcceptanceLimits& limits)
      : input_(input),
        fitted_(fitted),
        corners_(corners),
        patterns_(patterns),
        limits_(limits),
        scale_(scale_of(input.nominal.vehicle)) {}

  CameraAccuracy camera(size_t c) const {
    CameraAccuracy made;
    Rms px, ground_m, across_m;
    for (const auto& seen : corners_) {
      if (seen.camera != c || !counts(seen)) continue;
      ++made.points;
      const UnknownChart& chart = fitted_.solution.charts[seen.chart];
      const auto off = residual_px(sighting_of(seen, patterns_), fitted_.solution.cameras[c], chart);
      if (seen.rejected || !off) continue;
      px.add(off->norm());
      const auto ground = ground_of_seen(seen);
      if (!ground) continue;
      const Vector2d error = *ground - place_of(seen);
      const Vector2d sight =
          (place_of(seen) - fitted_.solution.cameras[c].vehicle_from_camera.translation.head<2>())
              .normalized();
      ground_m.add(error.norm());
      across_m.add(error.dot(Vector2d(-sight.y(), sight.x())));
    }
    made.inliers = px.count();
    made.rms_px = px.value();
    made.ground_rms_cm = kCmPerM * ground_m.value();
    made.ground_across_rms_cm = kCmPerM * across_m.value();
    add_uncertainty(c, made);
    add_reasons(c, made);
    return made;
  }

  OverlapAccuracy overlap(size_t a, size_t b) const {
    Rms apart_m;
    for (const auto& one : corners_) {
      if (one.camera != a || one.rejected || !counts(one)) continue;
      for (const auto& other : corners_) {
        if (other.camera != b || other.rejected || other.chart != one.chart || other.corner != one.corner)
          continue;
        const auto here = ground_of_seen(one), there = ground_of_seen(other);
        if (here && there) apart_m.add((*here - *there).norm());
      }
    }
    return {kCmPerM * apart_m.value(), apart_m.count()};
  }

 private:
  bool counts(const SeenCorner& seen) const { return input_.hold_out == HoldOut::kNone || seen.held_out; }

  Vector2d place_of(const SeenCorner& seen) const {
    const auto& pose = fitted_.solution.charts[seen.chart].vehicle_from_chart;
    return pose * patterns_[seen.chart].corners[static_cast<size_t>(seen.corner)].place_m;
  }

  std::optional<Vector2d> ground_of_seen(const SeenCorner& seen) const {
    const UnknownCamera& camera = fitted_.solution.cameras[seen.camera];
    return ground_of(*camera.lens, camera.vehicle_from_camera, seen.pixel);
  }

  void add_uncertainty(size_t c, CameraAccuracy& made) const {
    const Eigen::MatrixXd& covariance = fitted_.solution.covariance[c];
    for (int axis = 0; axis < 3; ++axis) {
      made.sigma_rotation_deg[axis] = geometry::degrees(std::sqrt(covariance(axis, axis)));
      made.sigma_translation_mm[axis] = 1000 * std::sqrt(covariance(axis + 3, axis + 3));
    }
    made.ground_sigma_near_cm = ground_sigma_cm(c, 0.5 * scale_);
    made.ground_sigma_far_cm = ground_sigma_cm(c, 3 * scale_);
    made.lens_change_px = lens_change_px(c);
  }

  /// Over the corners, for what a lens does where none are, nothing tells.
  double lens_change_px(size_t c) const {
    if (!fitted_.solution.cameras[c].lens_prior) return 0;
    const geometry::Lens& given = *input_.nominal.cameras[c].lens;
    Rms change_px;
    for (const auto& seen : corners_) {
      if (seen.camera != c || seen.rejected || seen.held_out) continue;
      const auto ray = fitted_.solution.cameras[c].lens->unproject(seen.pixel);
      const auto pixel = ray ? given.project(*ray) : std::nullopt;
      if (pixel) change_px.add((*pixel - seen.pixel).norm());
    }
    return change_px.value();
  }

  /// Uncertainty of where the calibrated camera puts a point that far beside the vehicle, straight ahead of
  /// the camera: the covariance carried through the lens to the ground by differences.
  double ground_sigma_cm(size_t c, double beside_m) const {
    const UnknownCamera& camera = fitted_.solution.cameras[c];
    const Vector3d axis = camera.vehicle_from_camera.rotation * Vector3d::UnitZ();
    const Vector2d ahead = axis.head<2>().normalized();
    const Vector2d point = camera.vehicle_from_camera.translation.head<2>() + beside_m * ahead;
    const auto pixel =
        camera.lens->project(camera.vehicle_from_camera.inverse() * Vector3d(point.x(), point.y(), 0));
    if (!pixel) return 0;
    const Eigen::MatrixXd& covariance = fitted_.solution.relative_covariance[c];
    Eigen::MatrixXd slope = Eigen::MatrixXd::Zero(2, covariance.rows());
    for (Eigen::Index i = 0; i < covariance.rows(); ++i) {
      const double step = 1e-3 * std::sqrt(covariance(i, i));
      const auto after = ground_moved(camera, *pixel, i, step),
                 before = ground_moved(camera, *pixel, i, -step);
      if (after && before && step > 0) slope.col(i) = (*after - *before) / (2 * step);
    }
    return kCmPerM * std::sqrt((slope * covariance * slope.transpose()).trace());
  }

  static std::optional<Vector2d> ground_moved(const UnknownCamera& camera, const Vector2d& pixel,
                                              Eigen::Index unknown, double step) {
    Eigen::Matrix<double, 6, 1> pose_step = Eigen::Matrix<double, 6, 1>::Zero();
    geometry::LensPtr lens = camera.lens;
    if (unknown < 6) {
      pose_step[unknown] = step;
    } else {
      std::vector<double> parameters = geometry::lens_parameters(*lens);
      parameters[static_cast<size_t>(unknown - 6)] += step;
      lens = geometry::with_parameters(*lens, parameters);
      if (!lens) return std::nullopt;
    }
    const auto pose =
        geometry::turned_and_shifted(camera.vehicle_from_camera, pose_step.head<3>(), pose_step.tail<3>());
    return ground_of(*lens, pose, pixel);
  }

  void add_reasons(size_t c, CameraAccuracy& made) const {
    auto& reasons = made.reasons;
    if (made.inliers < limits_.least_inliers) {
      reasons.push_back("too few corners: " + std::to_string(made.inliers) + ", expected at least " +
                        std::to_string(limits_.least_inliers));
      return;
    }
    if (made.inliers < limits_.least_inlier_share * made.points)
      reasons.push_back("only " + std::to_string(made.inliers) + " of " + std::to_string(made.points) +
                        " corners agree");
    const auto limit = [&](const char* what, double value, double most, const char* unit) {
      if (!(value <= most)) reasons.push_back(beyond(what, value, most, unit));
    };
    limit("the corners' distance from where they should be", made.rms_px, limits_.most_rms_px, "px RMS");
    limit("the corners' distance on the ground", made.ground_rms_cm, scale_ * limits_.most_ground_rms_cm,
          "cm RMS");
    limit("the uncertainty of the ground beside the vehicle", made.ground_sigma_near_cm,
          scale_ * limits_.most_ground_sigma_near_cm, "cm");
    limit("the uncertainty of the ground farther off", made.ground_sigma_far_cm,
          scale_ * limits_.most_ground_sigma_far_cm, "cm");
    const auto& pose = fitted_.solution.cameras[c].vehicle_from_camera;
    const auto& nominal = input_.nominal.cameras[c].vehicle_from_camera;
    const auto tolerance = input_.tolerance.value_or(tape_tolerance(input_.nominal.vehicle));
    limit("the turn from the nominal pose",
          geometry::degrees(pose.rotation.angularDistance(nominal.rotation)),
          limits_.most_turn_from_nominal * tolerance.rotation_deg, "degrees");
    limit("the shift from the nominal pose", (pose.translation - nominal.translation).norm(),
          limits_.most_shift_from_nominal * tolerance.position_m, "m");
    if (made.lens_change_px > limits_.most_lens_change_px)
      reasons.push_back(beyond("the lens does not fit: its change", made.lens_change_px,
                               limits_.most_lens_change_px, "px RMS over the corners"));
  }

  const CalibrationInput& input_;
  const FittedEstimate& fitted_;
  const std::vector<SeenCorner>& corners_;
  const std::vector<ChartPattern>& patterns_;
  const AcceptanceLimits& limits_;
  double scale_;
};

}  // namespace

double scale_of(const geometry::Vehicle& vehicle) {
  return std::min(1.0, vehicle.length_m / kCarLengthM);
}

void judge(const CalibrationInput& input, const FittedEstimate& fitted,
           const std::vector<SeenCorner>& corners, const std::vector<ChartPattern>& patterns,
           const AcceptanceLimits& limits, Calibration& calibration) {
  const Judge judge(input, fitted, corners, patterns, limits);
  const auto& cameras = input.nominal.cameras;
  const double most_cm = scale_of(input.nominal.vehicle) * limits.most_overlap_rms_cm;
  for (size_t c = 0; c < cameras.size(); ++c) calibration.cameras.push_back(judge.camera(c));
  for (size_t c = 0; c < cameras.size(); ++c) {
    const size_t next = (c + 1) % cameras.size();
    const std::string name = cameras[c].name + "-" + cameras[next].name;
    const OverlapAccuracy overlap = judge.overlap(c, next);
    if (overlap.rms_cm > most_cm)
      calibration.reasons.push_back(
          beyond(name + ": the distance of corners seen by both", overlap.rms_cm, most_cm, "cm RMS"));
    calibration.overlaps[name] = overlap;
  }
}

}  // namespace svchain::calibration
