#pragma once
// OpencvBaseline on two threads: the composite cut into strips of rows, shared out by cv::parallel_for_,
// whose threads wait between frames. One thread calls it; OpenCV has two threads while the object lives, and
// as many as before when it is gone.

#include "usecases/svchain_bench/opencv_baseline.h"

namespace svchain::bench {

class OpencvStrips {
 public:
  /// Borrows the baseline.
  explicit OpencvStrips(OpencvBaseline& baseline);
  ~OpencvStrips();
  OpencvStrips(const OpencvStrips&) = delete;
  OpencvStrips& operator=(const OpencvStrips&) = delete;

  void run(const std::array<cv::Mat, 4>& bgr, cv::Mat& out);

 private:
  OpencvBaseline& baseline_;
  int threads_before_;
};

}  // namespace svchain::bench
