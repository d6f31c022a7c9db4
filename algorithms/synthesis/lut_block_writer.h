#pragma once
// Turns the cells of one block after the other into a LUT's lists (geometric_lut.h). Borrows everything; one
// thread.

#include <algorithm>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "algorithms/synthesis/lut_cell.h"
#include "algorithms/synthesis/lut_writer.h"

namespace svchain::synthesis {

/// Most bytes that a block's content takes, where every pixel may have so many taps.
constexpr size_t most_block_content(size_t taps) {
  constexpr size_t kMostRegions = 10;  // black, background, four cameras, four pairs of neighbours
  constexpr size_t kPixels = size_t{kBlockSize} * kBlockSize;
  const size_t pixel = std::max<size_t>(taps * sizeof(uint32_t) + 1, 3) + sizeof(LutSpan);
  const size_t lists = kMostRegions * sizeof(LutRegion) + kMostRows * sizeof(LutRow) + kPixels * pixel;
  return (lists + 2 * kLutContentAlignment - 1) / kLutContentAlignment * kLutContentAlignment;
}

class LutBlockWriter {
 public:
  /// `background` (BGR, of the composite's size) is what cells of that kind show.
  LutBlockWriter(LutWriter& writer, LutHeader& header, const cv::Mat& background)
      : writer_(writer), header_(header), background_(background) {}

  /// `cells` are the block's, row by row; the block's place and size are set already. Throws
  /// std::invalid_argument where the block takes too much of a camera, or the memory does not suffice.
  void write(LutBlock& block, const Cell* cells);

 private:
  void find_sources(LutBlock& block, const Cell* cells);
  void find_overlaps(LutBlock& block, const Cell* cells);
  double q2(const Tap& tap) const;
  void find_rows(const LutBlock& block, const Cell* cells);
  void find_regions(const LutBlock& block, const Cell* cells);
  LutRegion region_of(const Cell& cell) const;
  void add_region(const LutBlock& block, const Cell* cells, LutRegion& region);
  void add_taps(const LutBlock& block, const LutRegion& region, const std::vector<const Cell*>& members);

  LutWriter& writer_;
  LutHeader& header_;
  const cv::Mat& background_;
  std::array<uint8_t, 4> source_of_camera_ = {};
  std::vector<LutRow> rows_;
  std::vector<LutRegion> regions_;
  std::vector<LutSpan> spans_;
  std::vector<uint32_t> entries_;
  std::vector<uint8_t> weights_;
  std::vector<std::array<uint8_t, 3>> pixels_;
};

}  // namespace svchain::synthesis
