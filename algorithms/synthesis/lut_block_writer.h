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
  /// Neighbours in a row that show alike.
  struct Run {
    int first, count;  // cells of the block
    size_t region;
  };
  /// Columns of a source's box that a block takes of one row.
  struct Reach {
    int left = 1 << 30, right = -1;
  };

  void find_runs(const LutBlock& block, const Cell* cells);
  void find_sources(LutBlock& block, const Cell* cells);
  void find_overlaps(LutBlock& block, const Cell* cells);
  void find_rows(const LutBlock& block, const Cell* cells);
  void add_region(const LutBlock& block, const Cell* cells, size_t region);
  void add_taps(const LutBlock& block, const Cell* cells, size_t region);

  LutWriter& writer_;
  LutHeader& header_;
  const cv::Mat& background_;
  std::vector<Run> runs_;
  std::vector<Cell> kinds_;  // a cell of every region, in the order in which their first pixels come
  std::array<uint8_t, 4> source_of_camera_ = {};
  std::vector<Reach> reaches_;
  std::vector<LutRow> rows_;
  std::vector<LutRegion> regions_;
  std::vector<LutSpan> spans_;
  std::vector<uint32_t> entries_;
  std::vector<uint8_t> weights_;
  std::vector<std::array<uint8_t, 3>> pixels_;
};

}  // namespace svchain::synthesis
