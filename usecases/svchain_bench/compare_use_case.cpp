#include "usecases/svchain_bench/comparisons.h"
#include "usecases/svchain_bench/surround_view.h"

namespace svchain::bench {

void compare_use_case(Results& results, const Progress& progress) {
  constexpr int kRounds = 9, kFrames = 40;
  constexpr double kFps = 30;
  constexpr int kTimedFrames = 300;
  progress("chain.frames_vs_kernels");
  const ParkedCar car;
  Kernels kernels(car, {880, 1080});
  kernels.frame_ms(kFrames);
  results.ratios["chain.frames_vs_kernels"] = measure_paired(
      kRounds, [&] { return kernels.frame_ms(kFrames); }, [&] { return use_case_frame_ms(car, kFrames); });
  progress("chain.capture_to_display_p99_ms");
  results.figures["chain.capture_to_display_p99_ms"] = use_case_latency_p99_ms(car, kFps, kTimedFrames);
}

}  // namespace svchain::bench
