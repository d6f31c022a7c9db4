#include "usecases/svchain_bench/opencv_baseline.h"

#include <opencv2/imgproc.hpp>

#include "algorithms/synthesis/lut_pixels.h"

namespace svchain::bench {
namespace {

using synthesis::GeometricLut;
using synthesis::kOnePixel;
using synthesis::LutPixel;
using synthesis::RegionKind;

/// The nearest integer to there (255 - weight) + sample weight, in 255ths.
void blend_bytes(uint8_t* there, const uint8_t* samples, const uint8_t* weights, int count) {
  for (int i = 0; i < count; ++i) {
    const auto w = static_cast<uint16_t>(weights[i]);
    const auto t = static_cast<uint16_t>(there[i] * static_cast<uint16_t>(255 - w) + samples[i] * w + 128);
    there[i] = static_cast<uint8_t>(static_cast<uint16_t>(t + (t >> 8)) >> 8);
  }
}

/// Pixels between those that a camera is seen in repeat a neighbour, so that sampling them is cheap.
void fill_gaps(cv::Mat& map, cv::Vec2f last) {
  for (int y = 0; y < map.rows; ++y)
    for (auto* at = map.ptr<cv::Vec2f>(y); at != map.ptr<cv::Vec2f>(y) + map.cols; ++at)
      (*at)[0] < 0 ? * at = last : last = *at;
}

}  // namespace

OpencvBaseline::OpencvBaseline(const GeometricLut& lut, const synthesis::ToneMapping& tone_mapping) {
  const cv::Size view(lut.header().width, lut.header().height);
  cv::Mat picture = cv::Mat::zeros(view, CV_8UC3), mask = cv::Mat::zeros(view, CV_8U);
  for (const synthesis::LutBlock& block : lut.blocks())
    for_each_pixel(lut, block, [&](const LutPixel& pixel) {
      if (!pixel.background) return;
      std::copy_n(pixel.background, 3, picture.at<cv::Vec3b>(pixel.row, pixel.column).val);
      mask.at<uint8_t>(pixel.row, pixel.column) = 255;
    });
  background_place_ = cv::boundingRect(mask);
  background_ = picture(background_place_).clone();
  for (int camera = 0; camera < 4; ++camera) read_camera(lut, camera, tone_mapping);
}

void OpencvBaseline::read_camera(const GeometricLut& lut, int index,
                                 const synthesis::ToneMapping& tone_mapping) {
  const cv::Size view(lut.header().width, lut.header().height);
  cv::Mat map(view, CV_32FC2, cv::Scalar(-1, -1)), weights = cv::Mat::zeros(view, CV_8UC3);
  for (const synthesis::LutBlock& block : lut.blocks())
    for_each_pixel(lut, block, [&](const LutPixel& pixel) {
      const int others[] = {pixel.region->first, pixel.region->second};
      for (int i = 0; i < pixel.region->tap_count(); ++i) {
        const synthesis::LutSource& source = block.sources[others[i]];
        if (source.camera != index) continue;
        const uint32_t entry = i == 0 ? pixel.first : pixel.second;
        map.at<cv::Vec2f>(pixel.row, pixel.column) =
            cv::Vec2f(static_cast<float>(source.x * kOnePixel + synthesis::entry_x(entry)),
                      static_cast<float>(source.y * kOnePixel + synthesis::entry_y(entry))) /
            float{kOnePixel};
        // Cameras are laid down by number: the lower one as it is, the other over it by its share.
        const int other = pixel.region->tap_count() == 2 ? block.sources[others[1 - i]].camera : 4;
        const int share = i == 0 ? pixel.weight : 255 - pixel.weight;
        weights.at<cv::Vec3b>(pixel.row, pixel.column) =
            cv::Vec3b::all(cv::saturate_cast<uint8_t>(other < index ? share : 255));
      }
    });
  Camera& camera = cameras_[index];
  cv::Mat covered;
  cv::extractChannel(weights, covered, 0);
  camera.place = cv::boundingRect(covered);
  cv::Mat part = map(camera.place).clone();
  fill_gaps(part, cv::Vec2f(0, 0));
  cv::convertMaps(part, cv::noArray(), camera.xy, camera.fraction, CV_16SC2);
  camera.weights = weights(camera.place).clone();
  camera.curves.create(1, 256, CV_8UC3);
  for (int v = 0; v < 256; ++v)
    for (int c = 0; c < 3; ++c)
      camera.curves.at<cv::Vec3b>(v)[c] = tone_mapping.curves[size_t(index)][size_t(c)][size_t(v)];
}

void OpencvBaseline::blend(const Camera& camera, cv::Mat& out) {
  for (int y = 0; y < camera.place.height; ++y)
    blend_bytes(out.ptr(camera.place.y + y) + camera.place.x * 3, camera.samples.ptr(y),
                camera.weights.ptr(y), camera.place.width * 3);
}

void OpencvBaseline::run(const std::array<cv::Mat, 4>& bgr, cv::Mat& out) {
  for (size_t i = 0; i < cameras_.size(); ++i) {
    Camera& camera = cameras_[i];
    cv::remap(bgr[i], camera.samples, camera.xy, camera.fraction, cv::INTER_LINEAR, cv::BORDER_REPLICATE);
    cv::LUT(camera.samples, camera.curves, camera.samples);
    blend(camera, out);
  }
  background_.copyTo(out(background_place_));
}

void OpencvBaseline::run_nv12(const std::array<cv::Mat, 4>& nv12, cv::Mat& out) {
  for (size_t i = 0; i < cameras_.size(); ++i) cv::cvtColor(nv12[i], converted_[i], cv::COLOR_YUV2BGR_NV12);
  run(converted_, out);
}

}  // namespace svchain::bench
