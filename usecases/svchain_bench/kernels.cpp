#include "algorithms/geometry/view.h"
#include "algorithms/synthesis/synthesize.h"
#include "usecases/svchain_bench/round_trips.h"
#include "usecases/svchain_bench/surround_view.h"

namespace svchain::bench {

Kernels::Kernels(const ParkedCar& car, const Eigen::Vector2i& size_px) : pictures_(car.pictures()) {
  geometry::View view;
  view.size_px = size_px;
  view.metres_per_px = geometry::default_metres_per_px(car.rig().vehicle, size_px);
  lut_memory_.resize(synthesis::geometric_lut_capacity(view, 4));
  synthesis::build_geometric_lut(car.rig(), view, {}, lut_memory_);
  lut_ = std::make_unique<synthesis::GeometricLut>(lut_memory_);
  statistics_memory_.resize(synthesis::OverlapStatistics::bytes_for(view));
  photometric::AlignmentSettings settings;  // those of the use case
  settings.most_blocks = statistics_memory_.size() / sizeof(synthesis::OverlapBlock);
  alignment_ = std::make_unique<photometric::PhotometricAlignment>(settings);
  composite_.create(size_px.y(), size_px.x(), CV_8UC3);
}

void Kernels::synthesize() {
  synthesis::synthesize(*lut_, pictures_, alignment_->tone_mapping(), composite_,
                        synthesis::OverlapStatistics::create(statistics_memory_));
}

void Kernels::align() {
  alignment_->update(*reinterpret_cast<const synthesis::OverlapStatistics*>(statistics_memory_.data()));
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
