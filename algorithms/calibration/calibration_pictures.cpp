#include "algorithms/calibration/calibration_pictures.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cstdio>
#include <iterator>
#include <opencv2/imgproc.hpp>

#include "algorithms/synthesis/geometric_lut.h"
#include "algorithms/synthesis/synthesize.h"

namespace svchain::calibration {

namespace {

constexpr int kUsualWidthPx = 1280;  // where marks have their usual size
constexpr int kLongerSidePx = 1600;
constexpr double kAroundSides = 1.5;  // a chart's outermost squares and the white around them

struct Mark {
  const char* name;
  cv::Scalar bgr;
};

/// By CornerState.
const std::array<Mark, 4> kMarks = {{{"fitted", {60, 220, 60}},
                                     {"held out", {255, 120, 40}},
                                     {"rejected", {50, 50, 255}},
                                     {"not found", {40, 220, 255}}}};

const Mark& mark_of(CornerState state) {
  return kMarks[static_cast<size_t>(state)];
}

cv::Mat colour(const cv::Mat& picture) {
  cv::Mat bgr;
  if (picture.channels() == 1) {
    cv::cvtColor(picture, bgr, cv::COLOR_GRAY2BGR);
  } else {
    picture.copyTo(bgr);
  }
  return bgr;
}

/// Draws on a picture in units of its size, at fractions of a pixel.
class Pen {
 public:
  explicit Pen(cv::Mat& picture)
      : picture_(picture), unit_(std::max(1.0, static_cast<double>(picture.cols) / kUsualWidthPx)) {}

  void mark(CornerState state, const Eigen::Vector2d& pixel) {
    const double r = 5;
    const auto at = [&](double x, double y) { return fixed(pixel + unit_ * Eigen::Vector2d(x, y)); };
    const cv::Scalar& bgr = mark_of(state).bgr;
    switch (state) {
      case CornerState::kFitted:
        cv::circle(picture_, at(0, 0), static_cast<int>(r * unit_ * kOne), bgr, thickness(), cv::LINE_AA,
                   kShift);
        break;
      case CornerState::kHeldOut:
        cv::rectangle(picture_, at(-r, -r), at(r, r), bgr, thickness(), cv::LINE_AA, kShift);
        break;
      case CornerState::kRejected:
        stroke(at(-r, -r), at(r, r), bgr);
        stroke(at(-r, r), at(r, -r), bgr);
        break;
      case CornerState::kNotFound:
        stroke(at(-r, 0), at(r, 0), bgr);
        stroke(at(0, -r), at(0, r), bgr);
        break;
    }
  }

  void line(const Eigen::Vector2d& from, const Eigen::Vector2d& to, const cv::Scalar& bgr) {
    stroke(fixed(from), fixed(to), bgr);
  }

  /// One line of the legend, from above.
  void legend(int line, const std::string& text, CornerState* mark_before) {
    const Eigen::Vector2d left(18, 24 + 20 * line);
    if (mark_before) mark(*mark_before, unit_ * left);
    const cv::Point at(static_cast<int>(unit_ * (left.x() + (mark_before ? 14 : -8))),
                       static_cast<int>(unit_ * (left.y() + 5)));
    cv::putText(picture_, text, at, cv::FONT_HERSHEY_SIMPLEX, 0.5 * unit_, {255, 255, 255}, thickness(),
                cv::LINE_AA);
  }

  /// Darkens what the legend is written on.
  void ground_of_legend(int lines) {
    const cv::Rect box(0, 0, static_cast<int>(230 * unit_), static_cast<int>((18 + 20 * lines) * unit_));
    cv::Mat part = picture_(box & cv::Rect({0, 0}, picture_.size()));
    part.convertTo(part, -1, 0.3);
  }

 private:
  static constexpr int kShift = 4;
  static constexpr int kOne = 1 << kShift;

  static cv::Point fixed(const Eigen::Vector2d& pixel) {
    return {cvRound(kOne * pixel.x()), cvRound(kOne * pixel.y())};
  }
  int thickness() const { return std::max(1, static_cast<int>(unit_)); }
  void stroke(cv::Point from, cv::Point to, const cv::Scalar& bgr) {
    cv::line(picture_, from, to, bgr, thickness(), cv::LINE_AA, kShift);
  }

  cv::Mat& picture_;
  double unit_;
};

std::string title(const std::string& camera, const CameraAccuracy& accuracy) {
  char text[80];
  std::snprintf(text, sizeof text, "%s, %.2f px RMS", camera.c_str(), accuracy.rms_px);
  return text;
}

}  // namespace

cv::Mat corners_picture(const cv::Mat& picture, size_t camera, const Calibration& calibration) {
  cv::Mat drawn = colour(picture);
  Pen pen(drawn);
  std::array<int, 4> counts = {};
  for (const auto& corner : calibration.corners) {
    if (corner.camera != camera) continue;
    ++counts[static_cast<size_t>(corner.state)];
    const bool found = corner.state != CornerState::kNotFound;
    if (corner.state == CornerState::kRejected)
      pen.line(corner.found_px, corner.predicted_px, mark_of(corner.state).bgr);
    pen.mark(corner.state, found ? corner.found_px : corner.predicted_px);
  }
  pen.ground_of_legend(1 + static_cast<int>(kMarks.size()));
  pen.legend(0, title(geometry::kCameraNames[camera], calibration.cameras[camera]), nullptr);
  for (int i = 0; i < static_cast<int>(kMarks.size()); ++i) {
    auto state = static_cast<CornerState>(i);
    pen.legend(1 + i, std::to_string(counts[static_cast<size_t>(i)]) + " " + mark_of(state).name, &state);
  }
  return drawn;
}

geometry::View charts_view(const geometry::Vehicle& vehicle, const std::vector<Chart>& charts) {
  Eigen::AlignedBox2d box(Eigen::Vector2d(-vehicle.length_m / 2, -vehicle.width_m / 2),
                          Eigen::Vector2d(vehicle.length_m / 2, vehicle.width_m / 2));
  for (const auto& chart : charts) {
    if (!chart.vehicle_from_chart) continue;
    for (const auto& corner : corners(chart)) {
      for (const double x : {-kAroundSides, kAroundSides}) {
        for (const double y : {-kAroundSides, kAroundSides})
          box.extend(*chart.vehicle_from_chart * (corner.place_m + chart.side_m * Eigen::Vector2d(x, y)));
      }
    }
  }
  geometry::View view;
  view.metres_per_px = box.sizes().maxCoeff() / kLongerSidePx;
  // Forward is up: x is the height.
  view.size_px =
      (Eigen::Vector2d(box.sizes().y(), box.sizes().x()) / view.metres_per_px).array().round().cast<int>();
  view.centre_m = box.center();
  return view;
}

cv::Mat stitched_picture(const std::vector<cv::Mat>& pictures, const Calibration& calibration) {
  const auto view = charts_view(calibration.rig.vehicle, calibration.charts);
  const size_t bytes = synthesis::geometric_lut_capacity(view, pictures.size());
  std::vector<uint64_t> memory((bytes + sizeof(uint64_t) - 1) / sizeof(uint64_t));
  const auto span = std::as_writable_bytes(std::span(memory));
  const size_t used = synthesis::build_geometric_lut(calibration.rig, view, {}, span);
  std::vector<cv::Mat> frames;
  std::transform(pictures.begin(), pictures.end(), std::back_inserter(frames), colour);
  cv::Mat stitched(view.size_px.y(), view.size_px.x(), CV_8UC3);
  synthesis::synthesize(synthesis::GeometricLut(span.first(used)), frames, synthesis::ToneMapping::identity(),
                        stitched, nullptr);
  return stitched;
}

}  // namespace svchain::calibration
