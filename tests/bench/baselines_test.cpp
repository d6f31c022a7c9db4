#include <opencv2/core.hpp>

#include "tests/catch.h"
#include "usecases/svchain_bench/opencv_float_baseline.h"
#include "usecases/svchain_bench/opencv_strips.h"
#include "usecases/svchain_bench/synthesis_scene.h"

using namespace svchain::bench;

namespace {

constexpr double kLevels = 2;

cv::Mat black(const SynthesisScene& scene) {
  return cv::Mat::zeros(scene.composite.size(), CV_8UC3);
}

cv::Mat composite_of_baseline(SynthesisScene& scene) {
  OpencvBaseline baseline(scene.lut(), scene.curves);
  cv::Mat composite = black(scene);
  baseline.run(scene.sets.front().bgr, composite);
  return composite;
}

double apart(const cv::Mat& a, const cv::Mat& b) {
  return cv::norm(a, b, cv::NORM_INF);
}

}  // namespace

TEST_CASE("everything that synthesis is measured against makes its composite within 2 levels") {
  SynthesisScene scene{ParkedCar()};
  const cv::Mat expected = composite_of_baseline(scene);
  REQUIRE(cv::mean(expected)[0] > 10);

  SECTION("synthesis itself") {
    scene.synthesize(scene.sets.front().bgr_pictures, svchain::synthesis::best_kernel());
    CHECK(apart(scene.composite, expected) <= kLevels);
  }
  SECTION("synthesis in parts on two threads, the same byte by byte") {
    scene.synthesize(scene.sets.front().bgr_pictures, svchain::synthesis::best_kernel());
    const cv::Mat whole = scene.composite.clone();
    scene.composite.setTo(0);
    svchain::Workers workers(1);
    scene.synthesize(scene.sets.front().bgr_pictures, svchain::synthesis::best_kernel(), workers);
    CHECK(apart(scene.composite, whole) == 0);
  }
  SECTION("float maps and a float blend") {
    OpencvFloatBaseline baseline(scene.lut(), scene.curves);
    cv::Mat composite = black(scene);
    baseline.run(scene.sets.front().bgr, composite);
    CHECK(apart(composite, expected) <= kLevels);
  }
  SECTION("strips on two threads, the same byte by byte") {
    OpencvBaseline baseline(scene.lut(), scene.curves);
    OpencvStrips strips(baseline);
    cv::Mat composite = black(scene);
    strips.run(scene.sets.front().bgr, composite);
    CHECK(apart(composite, expected) == 0);
  }
}

TEST_CASE("a strip of rows leaves all other rows as they are") {
  SynthesisScene scene{ParkedCar()};
  const cv::Mat expected = composite_of_baseline(scene);
  OpencvBaseline baseline(scene.lut(), scene.curves);
  cv::Mat composite = black(scene);
  baseline.run_rows({300, 700}, scene.sets.front().bgr, composite);
  CHECK(apart(composite.rowRange(300, 700), expected.rowRange(300, 700)) == 0);
  CHECK(cv::norm(composite.rowRange(0, 300), cv::NORM_INF) == 0);
  CHECK(cv::norm(composite.rowRange(700, composite.rows), cv::NORM_INF) == 0);
}

TEST_CASE("OpenCV has as many threads after strips as before") {
  SynthesisScene scene{ParkedCar()};
  OpencvBaseline baseline(scene.lut(), scene.curves);
  cv::setNumThreads(1);
  {
    const OpencvStrips strips(baseline);
    CHECK(cv::getNumThreads() == 2);
  }
  CHECK(cv::getNumThreads() == 1);
}
