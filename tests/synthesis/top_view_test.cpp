#include <opencv2/core.hpp>

#include "algorithms/synthesis/synthesize.h"
#include "tests/catch.h"
#include "tests/synthesis/decoded_lut.h"
#include "tests/synthesis/four_cameras.h"

using namespace svchain;
using namespace svchain::synthesis;
using namespace svchain::testing;

namespace {

/// A smooth ground, different in every channel and nowhere symmetric.
Eigen::Vector3d ground_colour(const Eigen::Vector2d& p) {
  return {128 + 90 * std::sin(1.1 * p.x() + 0.4 * p.y()), 128 + 90 * std::cos(0.5 * p.x() - 1.2 * p.y()),
          128 + 60 * std::sin(1.3 * p.y()) + 30 * std::cos(0.9 * p.x())};
}

/// What a camera on that ground pictures: every pixel's ray is followed down to it.
cv::Mat picture(const geometry::Camera& camera) {
  cv::Mat frame(camera.image_size_px.y(), camera.image_size_px.x(), CV_8UC3, cv::Scalar(200, 150, 100));
  for (int v = 0; v < frame.rows; ++v)
    for (int u = 0; u < frame.cols; ++u) {
      const auto ray = camera.lens->unproject({u, v});
      if (!ray) continue;
      const Eigen::Vector3d direction = camera.vehicle_from_camera.rotation * *ray;
      const Eigen::Vector3d& eye = camera.vehicle_from_camera.translation;
      if (direction.z() > -1e-3) continue;
      const Eigen::Vector3d colour = ground_colour((eye - direction * (eye.z() / direction.z())).head<2>());
      for (int c = 0; c < 3; ++c) frame.at<cv::Vec3b>(v, u)[c] = cv::saturate_cast<uint8_t>(colour[c]);
    }
  return frame;
}

}  // namespace

TEST_CASE("four pictures of a known ground give that ground seen from above") {
  const auto rig = four_cameras({640, 360});
  const auto view = view_of(rig, {220, 270});
  std::vector<cv::Mat> frames;
  for (const auto& camera : rig.cameras) frames.push_back(picture(camera));
  const OwnedLut owned(rig, view);
  cv::Mat out(270, 220, CV_8UC3);
  synthesize(owned.lut(), frames, ToneMapping::identity(), out, nullptr);

  const DecodedLut lut = decode(owned.lut());
  double sum = 0, largest = 0;
  size_t compared = 0;
  for (int row = 0; row < lut.height; ++row)
    for (int column = 0; column < lut.width; ++column) {
      if (lut.at(column, row).tap_count() == 0) continue;
      const Eigen::Vector3d truth = ground_colour(view.ground_from_pixel({column, row}));
      for (int c = 0; c < 3; ++c) {
        const double error = std::abs(out.at<cv::Vec3b>(row, column)[c] - truth[c]);
        sum += error;
        largest = std::max(largest, error);
        ++compared;
      }
    }
  CHECK(compared > 3 * 40000);
  CHECK(sum / double(compared) < 0.5);
  CHECK(largest < 5);
}
