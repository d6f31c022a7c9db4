#include "usecases/svchain_bench/opencv_baseline.h"

#include <opencv2/imgproc.hpp>

namespace svchain::bench {
namespace {

/// The nearest integer to there (255 - weight) + sample weight, in 255ths.
void blend_bytes(uint8_t* there, const uint8_t* samples, const uint8_t* weights, int count) {
  for (int i = 0; i < count; ++i) {
    const auto w = static_cast<uint16_t>(weights[i]);
    const auto t = static_cast<uint16_t>(there[i] * static_cast<uint16_t>(255 - w) + samples[i] * w + 128);
    there[i] = static_cast<uint8_t>(static_cast<uint16_t>(t + (t >> 8)) >> 8);
  }
}

/// The rows of a rectangle that are in a strip, counted from the rectangle's first.
cv::Range rows_of(const cv::Rect& place, const cv::Range& strip) {
  const cv::Range common = strip & cv::Range(place.y, place.y + place.height);
  return common - place.y;
}

}  // namespace

OpencvBaseline::OpencvBaseline(const synthesis::GeometricLut& lut, const synthesis::ToneMapping& tone_mapping)
    : background_(background(lut)) {
  for (int i = 0; i < 4; ++i) {
    const CameraMap map = camera_map(lut, i, tone_mapping);
    Camera& camera = cameras_[i];
    camera.place = map.place;
    camera.weights = map.weights;
    camera.curves = map.curves;
    cv::convertMaps(map.xy, cv::noArray(), camera.xy, camera.fraction, CV_16SC2);
    camera.samples.create(map.place.size(), CV_8UC3);
  }
}

void OpencvBaseline::run(const std::array<cv::Mat, 4>& bgr, cv::Mat& out) {
  run_rows({0, out.rows}, bgr, out);
}

void OpencvBaseline::run_rows(const cv::Range& strip, const std::array<cv::Mat, 4>& bgr, cv::Mat& out) {
  for (size_t i = 0; i < cameras_.size(); ++i) {
    const Camera& camera = cameras_[i];
    const cv::Range rows = rows_of(camera.place, strip);
    if (rows.empty()) continue;
    cv::Mat samples = camera.samples.rowRange(rows);
    cv::remap(bgr[i], samples, camera.xy.rowRange(rows), camera.fraction.rowRange(rows), cv::INTER_LINEAR,
              cv::BORDER_REPLICATE);
    cv::LUT(samples, camera.curves, samples);
    for (int y = rows.start; y < rows.end; ++y)
      blend_bytes(out.ptr(camera.place.y + y) + camera.place.x * 3, camera.samples.ptr(y),
                  camera.weights.ptr(y), camera.place.width * 3);
  }
  const cv::Range rows = rows_of(background_.place, strip);
  if (!rows.empty()) background_.picture.rowRange(rows).copyTo(out(background_.place).rowRange(rows));
}

void OpencvBaseline::run_nv12(const std::array<cv::Mat, 4>& nv12, cv::Mat& out) {
  for (size_t i = 0; i < cameras_.size(); ++i) cv::cvtColor(nv12[i], converted_[i], cv::COLOR_YUV2BGR_NV12);
  run(converted_, out);
}

}  // namespace svchain::bench
