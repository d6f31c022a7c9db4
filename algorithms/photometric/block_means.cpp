#include "algorithms/photometric/block_means.h"

#include <cmath>
#include <stdexcept>

#include "algorithms/synthesis/fixed_point.h"
#include "algorithms/synthesis/lut_pixels.h"

namespace svchain::photometric {
namespace {

using synthesis::kChannels;
using Colour = std::array<double, kChannels>;

/// Reads one camera's pixels as synthesis does.
class Reader {
 public:
  Reader(const synthesis::GeometricLut& lut, std::span<const cv::Mat> frames,
         const synthesis::ToneMapping& tone_mapping)
      : header_(lut.header()), frames_(frames), tone_mapping_(tone_mapping) {}

  void add(const synthesis::LutSource& box, uint32_t entry, Colour& sum) const {
    const uint32_t x = synthesis::entry_x(entry), y = synthesis::entry_y(entry);
    const cv::Mat& frame = frames_[box.camera];
    const int column = box.x + int(x >> synthesis::kFractionBits),
              row = box.y + int(y >> synthesis::kFractionBits);
    const auto& upper = frame.ptr<cv::Vec3b>(row) + column;
    const auto& lower = frame.ptr<cv::Vec3b>(row + 1) + column;
    const int32_t factor = falloff_factor(box, x, y);
    for (int c = 0; c < kChannels; ++c) {
      const uint8_t sample = synthesis::bilinear(upper[0][c], upper[1][c], lower[0][c], lower[1][c],
                                                 x % synthesis::kOnePixel, y % synthesis::kOnePixel);
      sum[c] += tone_mapping_.curves[box.camera][c][synthesis::unfade(sample, factor)];
    }
  }

 private:
  int32_t falloff_factor(const synthesis::LutSource& box, uint32_t x, uint32_t y) const {
    const auto [a1, a2] = tone_mapping_.falloff[box.camera];
    const auto [centre_x, centre_y] = header_.lens_centre[box.camera];
    const auto radial = synthesis::RadialScale::of(header_.image_size_px[box.camera][0]);
    const auto whole = [](uint32_t px) { return static_cast<int32_t>(px * synthesis::kOnePixel); };
    const auto dx = static_cast<int32_t>(x) + whole(box.x) - centre_x;
    const auto dy = static_cast<int32_t>(y) + whole(box.y) - centre_y;
    return synthesis::radial_factor(a1, a2, radial.q2(dx, dy));
  }

  const synthesis::LutHeader& header_;
  std::span<const cv::Mat> frames_;
  const synthesis::ToneMapping& tone_mapping_;
};

/// Adds a block's overlaps, at most one for each source that is the first of a pair.
void add_block(const synthesis::GeometricLut& lut, uint32_t index, const Reader& reader,
               std::vector<BlockMeans>& means) {
  const synthesis::LutBlock& block = lut.blocks()[index];
  std::array<BlockMeans, 4> of_first = {};
  synthesis::for_each_pixel(lut, block, [&](const synthesis::LutPixel& pixel) {
    const synthesis::LutRegion& region = *pixel.region;
    if (region.kind != synthesis::RegionKind::kBlend) return;
    BlockMeans& overlap = of_first[region.first];
    overlap.camera_a = block.sources[region.first].camera;
    overlap.camera_b = block.sources[region.second].camera;
    overlap.block = index;
    ++overlap.pixels;
    reader.add(block.sources[region.first], pixel.first, overlap.a);
    reader.add(block.sources[region.second], pixel.second, overlap.b);
  });
  for (BlockMeans& overlap : of_first) {
    if (overlap.pixels == 0) continue;
    for (int c = 0; c < kChannels; ++c) {
      overlap.a[c] /= overlap.pixels;
      overlap.b[c] /= overlap.pixels;
    }
    means.push_back(overlap);
  }
}

}  // namespace

double BlockMeans::difference() const {
  double sum = 0;
  for (int c = 0; c < kChannels; ++c) sum += std::abs(a[c] - b[c]);
  return sum / kChannels;
}

std::vector<BlockMeans> block_means(const synthesis::GeometricLut& lut, std::span<const cv::Mat> frames,
                                    const synthesis::ToneMapping& tone_mapping) {
  const synthesis::LutHeader& header = lut.header();
  if (frames.size() != header.camera_count) throw std::invalid_argument("block means: expected four frames");
  for (size_t i = 0; i < frames.size(); ++i)
    if (frames[i].type() != CV_8UC3 || frames[i].cols != header.image_size_px[i][0] ||
        frames[i].rows != header.image_size_px[i][1])
      throw std::invalid_argument("block means: a frame is not BGR of the size that the LUT was made for");

  const Reader reader(lut, frames, tone_mapping);
  std::vector<BlockMeans> means;
  for (uint32_t index = 0; index < lut.blocks().size(); ++index) add_block(lut, index, reader, means);
  return means;
}

}  // namespace svchain::photometric
