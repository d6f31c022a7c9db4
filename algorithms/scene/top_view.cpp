#include "algorithms/scene/top_view.h"

#include <algorithm>

#include "algorithms/scene/motion.h"

namespace svchain::scene {

cv::Mat ideal_top_view(const World& world, const geometry::View& view, double time_s) {
  constexpr int kSamples = 4;  // each way in a pixel
  const Pose2 pose = world_from_vehicle(world.scene().path, time_s);
  const double step = view.metres_per_px / kSamples;
  cv::Mat image(view.size_px.y(), view.size_px.x(), CV_8UC3);
  for (int j = 0; j < image.rows; ++j) {
    for (int i = 0; i < image.cols; ++i) {
      const Eigen::Vector2d centre = view.ground_from_pixel({i, j});
      const double reach = (pose * centre).norm() + view.metres_per_px;
      const auto index = world.level_for(std::min(step * 2, view.metres_per_px), reach);
      const GroundLevel& level = world.ground()[index.value_or(world.ground().size() - 1)];
      Eigen::Vector3d sum = Eigen::Vector3d::Zero();
      for (int k = 0; k < kSamples * kSamples; ++k) {
        const Eigen::Vector2d offset((k / kSamples + 0.5) * step, (k % kSamples + 0.5) * step);
        const Eigen::Vector2d place =
            pose * (centre + offset - Eigen::Vector2d::Constant(view.metres_per_px / 2));
        sum += sample(level.texture, level.texel_at(place.x()), level.texel_at(place.y()));
      }
      sum = (sum / (kSamples * kSamples)).array() + 0.5;
      image.at<cv::Vec3b>(j, i) = {static_cast<uint8_t>(sum[0]), static_cast<uint8_t>(sum[1]),
                                   static_cast<uint8_t>(sum[2])};
    }
  }
  return image;
}

}  // namespace svchain::scene
