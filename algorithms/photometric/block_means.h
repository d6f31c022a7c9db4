#pragma once
// How bright two cameras show what they share, block by block, as the composite has it: after falloff and
// tone mapping, from the frames themselves. For measuring what photometric alignment leaves; it takes about
// as long as synthesis. Pure function, any thread.

#include <array>
#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <span>
#include <vector>

#include "algorithms/synthesis/geometric_lut.h"
#include "algorithms/synthesis/tone_mapping.h"

namespace svchain::photometric {

struct BlockMeans {
  int camera_a = 0;  // the clockwise first of two neighbours
  int camera_b = 0;
  uint32_t block = 0;                             // index in the LUT
  int pixels = 0;                                 // that show both
  std::array<double, synthesis::kChannels> a, b;  // grey levels

  /// Mean over the channels of |a - b|.
  double difference() const;
};

/// Of every block and pair of cameras blended in it, in the order of the LUT's blocks. `frames` are BGR, one
/// for each camera of the LUT, of the size it was made for. Throws std::invalid_argument where they are not.
std::vector<BlockMeans> block_means(const synthesis::GeometricLut& lut, std::span<const cv::Mat> frames,
                                    const synthesis::ToneMapping& tone_mapping);

}  // namespace svchain::photometric
