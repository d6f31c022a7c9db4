#include "usecases/svchain_bench/camera_maps.h"

#include <opencv2/imgproc.hpp>

#include "algorithms/synthesis/lut_pixels.h"

namespace svchain::bench {

namespace {

using synthesis::GeometricLut;
using synthesis::kOnePixel;
using synthesis::LutPixel;

/// Pixels between those that a camera is seen in repeat a neighbour, so that sampling them is cheap.
void fill_gaps(cv::Mat& map, cv::Vec2f last) {
  for (int y = 0; y < map.rows; ++y)
    for (auto* at = map.ptr<cv::Vec2f>(y); at != map.ptr<cv::Vec2f>(y) + map.cols; ++at)
      (*at)[0] < 0 ? * at = last : last = *at;
}

cv::Mat curves_of(const synthesis::ToneMapping& tone_mapping, int camera) {
  cv::Mat curves(1, 256, CV_8UC3);
  for (int v = 0; v < 256; ++v)
    for (int c = 0; c < 3; ++c)
      curves.at<cv::Vec3b>(v)[c] = tone_mapping.curves[size_t(camera)][size_t(c)][size_t(v)];
  return curves;
}

/// Of the whole composite; -1 where the camera is not seen.
void read(const GeometricLut& lut, int camera, cv::Mat& map, cv::Mat& weights) {
  for (const synthesis::LutBlock& block : lut.blocks())
    for_each_pixel(lut, block, [&](const LutPixel& pixel) {
      const int others[] = {pixel.region->first, pixel.region->second};
      for (int i = 0; i < pixel.region->tap_count(); ++i) {
        const synthesis::LutSource& source = block.sources[others[i]];
        if (source.camera != camera) continue;
        const uint32_t entry = i == 0 ? pixel.first : pixel.second;
        map.at<cv::Vec2f>(pixel.row, pixel.column) =
            cv::Vec2f(static_cast<float>(source.x * kOnePixel + synthesis::entry_x(entry)),
                      static_cast<float>(source.y * kOnePixel + synthesis::entry_y(entry))) /
            float{kOnePixel};
        // Cameras are laid down by number: the lower one as it is, the other over it by its share.
        const int other = pixel.region->tap_count() == 2 ? block.sources[others[1 - i]].camera : 4;
        const int share = i == 0 ? pixel.weight : 255 - pixel.weight;
        weights.at<cv::Vec3b>(pixel.row, pixel.column) =
            cv::Vec3b::all(cv::saturate_cast<uint8_t>(other < camera ? share : 255));
      }
    });
}

}  // namespace

CameraMap camera_map(const GeometricLut& lut, int camera, const synthesis::ToneMapping& tone_mapping) {
  const cv::Size view(lut.header().width, lut.header().height);
  cv::Mat xy(view, CV_32FC2, cv::Scalar(-1, -1)), weights = cv::Mat::zeros(view, CV_8UC3);
  read(lut, camera, xy, weights);
  cv::Mat covered;
  cv::extractChannel(weights, covered, 0);
  const cv::Rect place = cv::boundingRect(covered);
  CameraMap map{place, xy(place).clone(), weights(place).clone(), curves_of(tone_mapping, camera)};
  fill_gaps(map.xy, cv::Vec2f(0, 0));
  return map;
}

Background background(const GeometricLut& lut) {
  const cv::Size view(lut.header().width, lut.header().height);
  cv::Mat picture = cv::Mat::zeros(view, CV_8UC3), mask = cv::Mat::zeros(view, CV_8U);
  for (const synthesis::LutBlock& block : lut.blocks())
    for_each_pixel(lut, block, [&](const LutPixel& pixel) {
      if (!pixel.background) return;
      std::copy_n(pixel.background, 3, picture.at<cv::Vec3b>(pixel.row, pixel.column).val);
      mask.at<uint8_t>(pixel.row, pixel.column) = 255;
    });
  const cv::Rect place = cv::boundingRect(mask);
  return {place, picture(place).clone()};
}

}  // namespace svchain::bench
