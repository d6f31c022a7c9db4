#include <algorithm>

#include "algorithms/synthesis/synthesize.h"
#include "usecases/svchain_bench/round_trips.h"
#include "usecases/svchain_bench/surround_view.h"

namespace svchain::bench {

geometry::View usual_view(const ParkedCar& car, const Eigen::Vector2i& size_px) {
  geometry::View view;
  view.size_px = size_px;
  view.metres_per_px = geometry::default_metres_per_px(car.rig().vehicle, size_px);
  return view;
}

Kernels::Kernels(const ParkedCar& car, const geometry::View& view) {
  const cv::Size size_px(view.size_px.x(), view.size_px.y());
  const size_t lut_bytes = synthesis::geometric_lut_capacity(view, 4);
  size_t bytes = PoolMemory::room_for(lut_bytes) + PoolMemory::room_for(size_px, CV_8UC3);
  for (const cv::Mat& picture : car.pictures()) bytes += PoolMemory::room_for(picture.size(), picture.type());
  memory_ = PoolMemory(bytes);
  std::transform(car.pictures().begin(), car.pictures().end(), pictures_.begin(),
                 [&](const cv::Mat& picture) { return memory_.place_copy(picture); });
  composite_ = memory_.place(size_px, CV_8UC3);
  const std::span<std::byte> lut_memory = memory_.place(lut_bytes);
  synthesis::build_geometric_lut(car.rig(), view, {}, lut_memory);
  lut_ = std::make_unique<synthesis::GeometricLut>(lut_memory);
  statistics_memory_.resize(synthesis::OverlapStatistics::bytes_for(view));
  photometric::AlignmentSettings settings;  // those of the use case
  settings.most_blocks = statistics_memory_.size() / sizeof(synthesis::OverlapBlock);
  alignment_ = std::make_unique<photometric::PhotometricAlignment>(settings);
}

void Kernels::synthesize(const std::array<cv::Mat, 4>& pictures) {
  synthesis::synthesize(*lut_, pictures, alignment_->tone_mapping(), composite_,
                        synthesis::OverlapStatistics::create(statistics_memory_));
}

void Kernels::align() {
  alignment_->update(*reinterpret_cast<const synthesis::OverlapStatistics*>(statistics_memory_.data()));
}

size_t Kernels::camera_pixels() const {
  size_t pixels = 0;
  for (const synthesis::LutBlock& block : lut_->blocks())
    for (const synthesis::LutRegion& region : lut_->regions(block))
      if (region.tap_count() > 0) pixels += region.pixels;
  return pixels;
}

double Kernels::frame_ms(int frames) {
  const int64_t start_ns = now_ns();
  for (int frame = 0; frame < frames; ++frame) {
    synthesize();
    align();
  }
  return static_cast<double>(now_ns() - start_ns) * 1e-6 / frames;
}

}  // namespace svchain::bench
