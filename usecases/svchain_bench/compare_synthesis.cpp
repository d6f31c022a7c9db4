#include <algorithm>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "algorithms/colour/convert.h"
#include "algorithms/geometry/view.h"
#include "algorithms/synthesis/synthesize.h"
#include "usecases/svchain_bench/comparisons.h"
#include "usecases/svchain_bench/opencv_baseline.h"
#include "usecases/svchain_bench/round_trips.h"
#include "usecases/svchain_bench/surround_view.h"

namespace svchain::bench {

namespace {

using synthesis::Kernel;

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

/// Everything that both sides read and write.
class Scene {
 public:
  explicit Scene(const ParkedCar& car) {
    view_.metres_per_px = geometry::default_metres_per_px(car.rig().vehicle, view_.size_px);
    lut_memory_.resize(synthesis::geometric_lut_capacity(view_, 4));
    synthesis::build_geometric_lut(car.rig(), view_, {}, lut_memory_);
    statistics_.resize(synthesis::OverlapStatistics::bytes_for(view_));
    for (size_t camera = 0; camera < 4; ++camera) {
      bgr[camera] = softened(car.pictures()[camera]);
      const cv::Size size = bgr[camera].size();
      nv12[camera].create(size.height * 3 / 2, size.width, CV_8U);
      bgr_pictures[camera] = colour::bgr_picture(bgr[camera]);
      nv12_pictures[camera] = colour::nv12_picture(size.width, size.height, nv12[camera].step[0],
                                                   nv12[camera].data, colour::YuvEncoding::kBt601Limited);
      colour::yuv_from_bgr(bgr_pictures[camera], nv12_pictures[camera]);
    }
  }

  synthesis::GeometricLut lut() const { return synthesis::GeometricLut(lut_memory_); }
  void ours(const std::array<colour::Picture, 4>& frames, Kernel kernel) {
    synthesis::synthesize(synthesis::GeometricLut(lut_memory_), frames, curves,
                          colour::bgr_picture(composite), synthesis::OverlapStatistics::create(statistics_),
                          kernel);
  }

  synthesis::ToneMapping curves = curves_of_slope_one();
  std::array<cv::Mat, 4> bgr, nv12;
  std::array<colour::Picture, 4> bgr_pictures, nv12_pictures;
  cv::Mat composite = cv::Mat::zeros(1080, 880, CV_8UC3);

 private:
  geometry::View view_;
  std::vector<std::byte> lut_memory_, statistics_;
};

using Way = std::function<void()>;

void require_same(const std::string& name, cv::Mat& composite, const Way& baseline, const Way& ours) {
  constexpr double kLevels = 2;
  baseline();
  const cv::Mat expected = composite.clone();
  composite.setTo(0);
  ours();
  const double apart = cv::norm(expected, composite, cv::NORM_INF);
  if (apart > kLevels)
    throw std::runtime_error(name + ": " + std::to_string(apart) + " levels from OpenCV's composite");
}

Cost time_of(const Way& way) {
  return [=] {
    const int64_t start_ns = now_ns();
    way();
    return static_cast<double>(now_ns() - start_ns) * 1e-6;
  };
}

}  // namespace

void compare_synthesis(Results& results, const Progress& progress) {
  constexpr int kRounds = 31;
  const ParkedCar car;
  Scene scene(car);
  OpencvBaseline opencv(scene.lut(), scene.curves);
  const auto compare = [&](const std::string& name, const Way& baseline, const Way& ours) {
    progress(name);
    require_same(name, scene.composite, baseline, ours);
    results.ratios[name] = measure_paired(kRounds, time_of(baseline), time_of(ours));
  };
  for (const Kernel kernel : synthesis::runnable_kernels()) {
    const std::string name = synthesis::name_of(kernel) + ".1t";
    compare(
        "synthesis." + name, [&] { opencv.run(scene.bgr, scene.composite); },
        [&] { scene.ours(scene.bgr_pictures, kernel); });
    compare(
        "synthesis.nv12." + name, [&] { opencv.run_nv12(scene.nv12, scene.composite); },
        [&] { scene.ours(scene.nv12_pictures, kernel); });
  }
}

}  // namespace svchain::bench
