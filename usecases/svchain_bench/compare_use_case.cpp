#include "usecases/svchain_bench/comparisons.h"
#include "usecases/svchain_bench/opencv_baseline.h"
#include "usecases/svchain_bench/round_trips.h"
#include "usecases/svchain_bench/surround_view.h"

namespace svchain::bench {

namespace {

/// What one would write instead of a chain: takes the four frames and makes the composite, over and over.
/// Milliseconds per frame.
double program_frame_ms(OpencvBaseline& opencv, const ParkedCar& car, cv::Mat& composite, int frames) {
  const int64_t start_ns = now_ns();
  for (int frame = 0; frame < frames; ++frame) opencv.run(car.pictures(), composite);
  return static_cast<double>(now_ns() - start_ns) * 1e-6 / frames;
}

}  // namespace

void compare_use_case(Results& results, const Progress& progress) {
  constexpr int kRounds = 9, kFrames = 40;
  constexpr double kFps = 30;
  constexpr int kTimedFrames = 300;
  const ParkedCar car;
  const Cost chain = [&] { return use_case_frame_ms(car, kFrames); };
  const geometry::View view = usual_view(car, {880, 1080});
  Kernels kernels(car, view);
  kernels.frame_ms(kFrames);
  progress("chain.frames_vs_kernels");
  results.ratios["chain.frames_vs_kernels"] = measure_paired(
      kRounds, [&] { return kernels.frame_ms(kFrames); }, chain);
  progress("chain.frames_vs_opencv_program");
  OpencvBaseline opencv(kernels.lut(), synthesis::ToneMapping::identity());
  cv::Mat composite = cv::Mat::zeros(view.size_px.y(), view.size_px.x(), CV_8UC3);
  results.ratios["chain.frames_vs_opencv_program"] = measure_paired(
      kRounds, [&] { return program_frame_ms(opencv, car, composite, kFrames); }, chain);
  progress("chain.capture_to_display_p99_ms");
  results.figures["chain.capture_to_display_p99_ms"] = use_case_latency_p99_ms(car, kFps, kTimedFrames);
}

}  // namespace svchain::bench
