#include "usecases/svchain_bench/opencv_float_baseline.h"

#include <opencv2/imgproc.hpp>

namespace svchain::bench {

namespace {

constexpr float kHalf = 0.5f;  // never below 0 or above 255: the cast rounds

void blend_bytes(uint8_t* there, const uint8_t* samples, const float* weights, int count) {
  for (int i = 0; i < count; ++i) {
    const auto t = static_cast<float>(there[i]), s = static_cast<float>(samples[i]);
    there[i] = static_cast<uint8_t>(kHalf + t + (s - t) * weights[i]);
  }
}

}  // namespace

OpencvFloatBaseline::OpencvFloatBaseline(const synthesis::GeometricLut& lut,
                                         const synthesis::ToneMapping& tone_mapping)
    : background_(background(lut)) {
  for (int i = 0; i < 4; ++i) {
    const CameraMap map = camera_map(lut, i, tone_mapping);
    Camera& camera = cameras_[i];
    camera.place = map.place;
    camera.curves = map.curves;
    cv::extractChannel(map.xy, camera.x, 0);
    cv::extractChannel(map.xy, camera.y, 1);
    map.weights.convertTo(camera.weights, CV_32F, 1 / 255.0);
  }
}

void OpencvFloatBaseline::run(const std::array<cv::Mat, 4>& bgr, cv::Mat& out) {
  for (size_t i = 0; i < cameras_.size(); ++i) {
    Camera& camera = cameras_[i];
    cv::remap(bgr[i], camera.samples, camera.x, camera.y, cv::INTER_LINEAR, cv::BORDER_REPLICATE);
    cv::LUT(camera.samples, camera.curves, camera.samples);
    for (int y = 0; y < camera.place.height; ++y)
      blend_bytes(out.ptr(camera.place.y + y) + camera.place.x * 3, camera.samples.ptr(y),
                  camera.weights.ptr<float>(y), camera.place.width * 3);
  }
  background_.picture.copyTo(out(background_.place));
}

}  // namespace svchain::bench
