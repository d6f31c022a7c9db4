#include <benchmark/benchmark.h>
#include <functional>

#include "usecases/svchain_bench/benchmarks.h"
#include "usecases/svchain_bench/surround_view.h"

namespace svchain::bench {

namespace {

/// Made when the first benchmark needs it.
const ParkedCar& parked_car() {
  static const ParkedCar car;
  return car;
}

void measure_kernel(benchmark::State& state, const std::function<void(Kernels&)>& kernel) {
  const Eigen::Vector2i size_px(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
  Kernels kernels(parked_car(), usual_view(parked_car(), size_px));
  kernels.synthesize();
  for ([[maybe_unused]] auto _ : state) kernel(kernels);
}

void measure_use_case(benchmark::State& state) {
  constexpr int kFrames = 40;
  for ([[maybe_unused]] auto _ : state)
    state.SetIterationTime(use_case_frame_ms(parked_car(), kFrames) * 1e-3);
}

}  // namespace

void register_surround_view_benchmarks() {
  const std::vector<std::vector<int64_t>> sizes_px = {{440, 540}, {880, 1080}, {1760, 2160}, {3520, 4320}};
  const auto add = [&](const char* name, const std::function<void(Kernels&)>& kernel) {
    auto* added = benchmark::RegisterBenchmark(name, measure_kernel, kernel)->Unit(benchmark::kMillisecond);
    for (const auto& size_px : sizes_px) added->Args(size_px);
  };
  add("synthesis", [](Kernels& kernels) { kernels.synthesize(); });
  add("photometric_alignment", [](Kernels& kernels) { kernels.align(); });
  benchmark::RegisterBenchmark("use_case/2dsv_2dsp", measure_use_case)
      ->UseManualTime()
      ->Iterations(5)
      ->Unit(benchmark::kMillisecond);
}

}  // namespace svchain::bench
