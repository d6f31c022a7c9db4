#include "usecases/svchain_bench/results.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <thread>

#include "usecases/svchain_page/machine.h"

namespace svchain::bench {

namespace {

constexpr const char* kRatios[] = {"synthesis.portable.1t",
                                   "synthesis.avx2.1t",
                                   "synthesis.avx512.1t",
                                   "synthesis.avx512.2t",
                                   "synthesis.nv12.avx512.1t",
                                   "chain.frames_vs_kernels",
                                   "hop.spin_park_rtt_over_raw_ring",
                                   "hop.parked_rtt_over_raw_futex",
                                   "hop.stream_vs_asio_post",
                                   "hop.stream_vs_gstreamer_queue"};
constexpr const char* kFigures[] = {"hop.same_core_ns", "bowl.gpu_fps", "bowl.cpu_moving_fps",
                                    "bowl.cpu_static_over_2d"};

/// To four digits: there are no more in it.
double rounded(double value) {
  if (value == 0) return 0;
  const double unit = std::pow(10, std::floor(std::log10(std::abs(value))) - 3);
  return unit >= 1 ? std::round(value / unit) * unit : std::round(value / unit) / std::round(1 / unit);
}

}  // namespace

Machine this_machine() {
  const unsigned cpus = std::thread::hardware_concurrency();
  return {page::processor() + ", " + std::to_string(cpus) + (cpus == 1 ? " CPU" : " CPUs"), page::compiler(),
          page::opencv_version()};
}

nlohmann::json json_of(const Results& results, const Machine& machine) {
  nlohmann::json json = {
      {"machine", machine.processor}, {"compiler", machine.compiler}, {"opencv", machine.opencv}};
  for (const char* name : kRatios) json["ratios"][name] = nullptr;
  for (const char* name : kFigures) json["figures"][name] = nullptr;
  for (const auto& [name, reason] : results.missing) json["ratios"][name] = nullptr;
  for (const auto& [name, paired] : results.ratios) {
    json["ratios"][name] = rounded(paired.ratio);
    json["quartiles"][name] = {rounded(paired.quarter), rounded(paired.three_quarters)};
    json["costs"][name] = {rounded(paired.a), rounded(paired.b)};
  }
  for (const auto& [name, figure] : results.figures) json["figures"][name] = rounded(figure);
  return json;
}

}  // namespace svchain::bench
