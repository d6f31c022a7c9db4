#include "usecases/svchain_bench/opencv_strips.h"

#include <opencv2/core/utility.hpp>

namespace svchain::bench {

namespace {

constexpr int kThreads = 2;
constexpr int kStrips = 32;  // strips differ in cost; the fastest of 2, 4, 8, 16 and 32

}  // namespace

OpencvStrips::OpencvStrips(OpencvBaseline& baseline)
    : baseline_(baseline), threads_before_(cv::getNumThreads()) {
  cv::setNumThreads(kThreads);
}

OpencvStrips::~OpencvStrips() {
  cv::setNumThreads(threads_before_);
}

void OpencvStrips::run(const std::array<cv::Mat, 4>& bgr, cv::Mat& out) {
  const auto row = [&](int strip) { return out.rows * strip / kStrips; };
  cv::parallel_for_(
      {0, kStrips},
      [&](const cv::Range& strips) {
        for (int i = strips.start; i < strips.end; ++i) baseline_.run_rows({row(i), row(i + 1)}, bgr, out);
      },
      kStrips);
}

}  // namespace svchain::bench
