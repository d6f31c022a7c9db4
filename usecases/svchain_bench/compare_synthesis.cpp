#include <opencv2/core.hpp>
#include <stdexcept>
#include <thread>

#include "usecases/svchain_bench/comparisons.h"
#include "usecases/svchain_bench/opencv_baseline.h"
#include "usecases/svchain_bench/opencv_float_baseline.h"
#include "usecases/svchain_bench/opencv_strips.h"
#include "usecases/svchain_bench/round_trips.h"
#include "usecases/svchain_bench/synthesis_scene.h"

namespace svchain::bench {

namespace {

using synthesis::Kernel;
using Set = SynthesisScene::Set;
using Way = std::function<void(const Set&)>;

void require_same(const std::string& name, SynthesisScene& scene, const Way& baseline, const Way& ours) {
  constexpr double kLevels = 2;
  cv::Mat& composite = scene.composite;
  baseline(scene.sets.front());
  const cv::Mat expected = composite.clone();
  composite.setTo(0);
  ours(scene.sets.front());
  const double apart = cv::norm(expected, composite, cv::NORM_INF);
  if (apart > kLevels)
    throw std::runtime_error(name + ": " + std::to_string(apart) + " levels from OpenCV's composite");
}

/// Milliseconds a frame of a stream, so long that what the other way has left in the caches at its begin
/// hardly counts.
Cost time_of(const Way& way, const std::vector<Set>& sets) {
  return [&sets, way] {
    constexpr int kPasses = 3;
    const int64_t start_ns = now_ns();
    for (int pass = 0; pass < kPasses; ++pass)
      for (const Set& set : sets) way(set);
    return static_cast<double>(now_ns() - start_ns) * 1e-6 / static_cast<double>(kPasses * sets.size());
  };
}

class Comparison {
 public:
  Comparison(Results& results, const Progress& progress) : results_(results), progress_(progress) {}

  void one_thread() {
    OpencvBaseline opencv(scene_.lut(), scene_.curves);
    OpencvFloatBaseline opencv_float(scene_.lut(), scene_.curves);
    for (const Kernel kernel : synthesis::runnable_kernels()) {
      const std::string name = synthesis::name_of(kernel) + ".1t";
      const Way ours = [&](const Set& set) { scene_.synthesize(set.bgr_pictures, kernel); };
      compare(
          "synthesis." + name, [&](const Set& set) { opencv.run(set.bgr, scene_.composite); }, ours);
      compare(
          "synthesis." + name + "_vs_float",
          [&](const Set& set) { opencv_float.run(set.bgr, scene_.composite); }, ours);
      compare(
          "synthesis.nv12." + name, [&](const Set& set) { opencv.run_nv12(set.nv12, scene_.composite); },
          [&](const Set& set) { scene_.synthesize(set.nv12_pictures, kernel); });
    }
  }

  void two_threads() {
    const bool can = std::thread::hardware_concurrency() >= 2;
    OpencvBaseline opencv(scene_.lut(), scene_.curves);
    OpencvStrips strips(opencv);
    Workers workers(1);
    for (const Kernel kernel : synthesis::runnable_kernels()) {
      const std::string name = "synthesis." + synthesis::name_of(kernel) + ".2t";
      if (can)
        compare(
            name, [&](const Set& set) { strips.run(set.bgr, scene_.composite); },
            [&](const Set& set) { scene_.synthesize(set.bgr_pictures, kernel, workers); });
      else
        results_.missing[name] = "one CPU";
    }
  }

 private:
  void compare(const std::string& name, const Way& baseline, const Way& ours) {
    constexpr int kRounds = 21;
    progress_(name);
    require_same(name, scene_, baseline, ours);
    results_.ratios[name] =
        measure_paired(kRounds, time_of(baseline, scene_.sets), time_of(ours, scene_.sets));
  }

  Results& results_;
  const Progress& progress_;
  SynthesisScene scene_{ParkedCar()};
};

}  // namespace

void compare_synthesis(Results& results, const Progress& progress) {
  Comparison comparison(results, progress);
  comparison.one_thread();
  comparison.two_threads();
}

}  // namespace svchain::bench
