#include "algorithms/bowl/viewpoint_lut.h"

#include <algorithm>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "algorithms/synthesis/lut_block_writer.h"
#include "algorithms/synthesis/lut_header.h"
#include "algorithms/synthesis/lut_writer.h"

namespace svchain::bowl {
namespace {

using synthesis::Cell;
using synthesis::kBlockSize;
using synthesis::LutBlock;
using synthesis::LutHeader;
static_assert(kBlockSize % SourceGrid::kSquarePx == 0);

/// Most that one block can take, so that blocks can be written anywhere in any order.
constexpr size_t kBlockBytes = synthesis::most_block_content(2);

}  // namespace

size_t ViewpointLut::capacity(const Eigen::Vector2i& size_px) {
  return sizeof(LutHeader) + synthesis::kLutContentAlignment +
         synthesis::block_count(size_px) * (sizeof(LutBlock) + kBlockBytes);
}

std::span<LutBlock> ViewpointLut::blocks() {
  return {reinterpret_cast<LutBlock*>(memory_.data() + sizeof(LutHeader)), header().block_count};
}

void ViewpointLut::begin(const Viewpoint& viewpoint, const Eigen::Vector2i& size_px,
                         std::span<std::byte> memory) {
  synthesis::require_aligned(memory);
  if (memory.size() < capacity(size_px)) synthesis::refuse("the memory does not suffice");
  memory_ = memory;
  header() = {};
  fill_header(header(), grid_.rig(), size_px);
  grid_.begin(viewpoint, size_px);
}

void ViewpointLut::write_blocks(int part, int parts) {
  const std::span<LutBlock> all = blocks();
  Part& made = parts_[part];
  made.first_block = all.size() * part / parts;
  made.end_block = all.size() * (part + 1) / parts;
  const size_t content = sizeof(LutHeader) + all.size_bytes() + synthesis::kLutContentAlignment;
  synthesis::LutWriter writer(memory_, content + made.first_block * kBlockBytes);
  LutHeader own = header();
  own.overlap_count = 0;
  const cv::Mat no_background;
  synthesis::LutBlockWriter block_writer(writer, own, no_background);
  std::vector<Cell> square(size_t{kBlockSize} * kBlockSize), cells(square.size());
  const int across = (own.width + kBlockSize - 1) / kBlockSize;
  for (size_t i = made.first_block; i < made.end_block; ++i) {
    LutBlock& block = all[i] = {};
    block.x = static_cast<uint16_t>(static_cast<int>(i) % across * kBlockSize);
    block.y = static_cast<uint16_t>(static_cast<int>(i) / across * kBlockSize);
    block.width = static_cast<uint16_t>(std::min(kBlockSize, own.width - block.x));
    block.height = static_cast<uint16_t>(std::min(kBlockSize, own.height - block.y));
    for (int y = 0; y < block.height; y += SourceGrid::kSquarePx)
      for (int x = 0; x < block.width; x += SourceGrid::kSquarePx)
        grid_.fill(block.x + x, block.y + y, &square[size_t(y) * kBlockSize + x], kBlockSize);
    if (block.width < kBlockSize)
      for (int y = 0; y < block.height; ++y)
        std::copy_n(&square[size_t(y) * kBlockSize], block.width, &cells[size_t(y) * block.width]);
    block_writer.write(block, block.width < kBlockSize ? cells.data() : square.data());
  }
  made.end = writer.used();
  made.overlap_count = own.overlap_count;
}

size_t ViewpointLut::finish(int parts) {
  const std::span<LutBlock> all = blocks();
  for (int part = 0; part < parts; ++part) {
    const Part& made = parts_[part];
    for (size_t i = made.first_block; i < made.end_block; ++i) all[i].first_overlap += header().overlap_count;
    header().overlap_count += made.overlap_count;
    header().bytes = static_cast<uint32_t>(made.end);
  }
  return header().bytes;
}

size_t ViewpointLut::build(const Viewpoint& viewpoint, const Eigen::Vector2i& size_px,
                           std::span<std::byte> memory) {
  begin(viewpoint, size_px, memory);
  make_nodes(0, 1);
  write_blocks(0, 1);
  return finish(1);
}

}  // namespace svchain::bowl
