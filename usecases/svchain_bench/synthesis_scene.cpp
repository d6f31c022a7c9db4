#include "usecases/svchain_bench/synthesis_scene.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "algorithms/colour/convert.h"

namespace svchain::bench {

namespace {

/// Curves take the same time whatever they are; these are the steepest that leave differences in rounding
/// what they are.
synthesis::ToneMapping curves_of_slope_one() {
  auto mapping = synthesis::ToneMapping::identity();
  for (size_t camera = 0; camera < 4; ++camera) {
    for (size_t channel = 0; channel < 3; ++channel) {
      for (size_t v = 0; v < 256; ++v)
        mapping.curves[camera][channel][v] =
            static_cast<uint8_t>(std::min<size_t>(255, v + 2 * camera + channel));
    }
  }
  return mapping;
}

/// So soft that what samples chroma in between and what takes the nearest agree, and without the darkest
/// values, where curves are steep: what is left are differences in rounding. Takes the same time as any
/// picture.
cv::Mat softened(const cv::Mat& picture) {
  cv::Mat small, soft;
  cv::resize(picture, small, picture.size() / 40, 0, 0, cv::INTER_AREA);
  cv::resize(small, soft, picture.size(), 0, 0, cv::INTER_CUBIC);
  return soft;
}

constexpr int kSets = 8;

cv::Size nv12_size(const cv::Size& size_px) {
  return {size_px.width, size_px.height * 3 / 2};
}

/// In bytes.
size_t room_for_sets(const std::array<cv::Mat, 4>& pictures) {
  size_t set = 0;
  for (const cv::Mat& picture : pictures)
    set += PoolMemory::room_for(picture.size(), CV_8UC3) +
           PoolMemory::room_for(nv12_size(picture.size()), CV_8U);
  return kSets * set;
}

}  // namespace

SynthesisScene::Set SynthesisScene::set_of(const std::array<cv::Mat, 4>& pictures) {
  Set set;
  for (size_t camera = 0; camera < pictures.size(); ++camera) {
    const cv::Size size = pictures[camera].size();
    set.bgr[camera] = memory_.place_copy(pictures[camera]);
    set.nv12[camera] = memory_.place(nv12_size(size), CV_8U);
    set.bgr_pictures[camera] = colour::bgr_picture(set.bgr[camera]);
    set.nv12_pictures[camera] =
        colour::nv12_picture(size.width, size.height, set.nv12[camera].step[0], set.nv12[camera].data,
                             colour::YuvEncoding::kBt601Limited);
    colour::yuv_from_bgr(set.bgr_pictures[camera], set.nv12_pictures[camera]);
  }
  return set;
}

SynthesisScene::SynthesisScene(const ParkedCar& car) : curves(curves_of_slope_one()) {
  const geometry::View view = usual_view(car, {880, 1080});
  const cv::Size size_px(view.size_px.x(), view.size_px.y());
  const size_t lut_bytes = synthesis::geometric_lut_capacity(view, 4);
  std::array<cv::Mat, 4> soft;
  std::transform(car.pictures().begin(), car.pictures().end(), soft.begin(), softened);
  memory_ = PoolMemory(PoolMemory::room_for(size_px, CV_8UC3) + PoolMemory::room_for(lut_bytes) +
                       room_for_sets(soft));
  composite = memory_.place(size_px, CV_8UC3);
  const std::span<std::byte> lut_memory = memory_.place(lut_bytes);
  synthesis::build_geometric_lut(car.rig(), view, {}, lut_memory);
  lut_ = std::make_unique<synthesis::GeometricLut>(lut_memory);
  statistics_memory_.resize(synthesis::OverlapStatistics::bytes_for(view));
  statistics_ = synthesis::OverlapStatistics::create(statistics_memory_);
  for (int i = 0; i < kSets; ++i) sets.push_back(set_of(soft));
}

void SynthesisScene::synthesize(const Pictures& frames, synthesis::Kernel kernel) {
  synthesis::synthesize(*lut_, frames, curves, colour::bgr_picture(composite), statistics_, kernel);
}

void SynthesisScene::synthesize(const Pictures& frames, synthesis::Kernel kernel, Workers& workers) {
  constexpr int kPartsPerCpu = 4;  // the link's
  const int parts = workers.cpus() * kPartsPerCpu;
  statistics_->expect(lut_->header().overlap_count);
  const auto part = [&](int i) {
    synthesis::synthesize_part({i, parts}, *lut_, frames, curves, colour::bgr_picture(composite), statistics_,
                               kernel);
  };
  using Part = decltype(part);
  workers.run(
      parts, [](const void* context, int i) { (*static_cast<const Part*>(context))(i); }, &part);
}

}  // namespace svchain::bench
