#pragma once
// What a viewpoint shows of the bowl, as a geometric LUT: synthesis then renders it with the kernels of the
// 2D view. Made so fast (source_grid.h) that the viewpoint may move with every frame. What is under the
// vehicle, over the rim or seen by no camera is black. Keeps lenses alive and borrows the memory from begin()
// to finish().
//
// The steps are begin(), make_nodes() of all parts, write_blocks() of all parts, finish(); parts of one step
// may run on any threads at the same time. begin() allocates where the picture has grown, write_blocks() a
// little.

#include <array>
#include <cstddef>
#include <span>

#include "algorithms/bowl/source_grid.h"
#include "algorithms/synthesis/geometric_lut.h"

namespace svchain::bowl {

class ViewpointLut {
 public:
  static constexpr int kMostParts = 16;

  /// Four cameras.
  ViewpointLut(const geometry::Rig& rig, const BowlSurface& surface, const synthesis::BlendShape& shape)
      : grid_(rig, surface, shape) {}

  /// Bytes that are enough for any LUT of a picture of this size.
  static size_t capacity(const Eigen::Vector2i& size_px);

  /// `viewpoint` is free of faults (check() of viewpoint.h). Throws std::invalid_argument where the memory
  /// does not suffice or is not aligned to 8 bytes.
  void begin(const Viewpoint& viewpoint, const Eigen::Vector2i& size_px, std::span<std::byte> memory);
  /// 1 to kMostParts parts, the same in all steps.
  void make_nodes(int part, int parts) { grid_.make_nodes(part, parts); }
  void write_blocks(int part, int parts);
  /// Bytes of the LUT.
  size_t finish(int parts);

  /// All of it, in one part.
  size_t build(const Viewpoint& viewpoint, const Eigen::Vector2i& size_px, std::span<std::byte> memory);

 private:
  struct Part {
    size_t first_block = 0, end_block = 0;
    size_t end = 0;  // of its content, bytes from the LUT's begin
    uint32_t overlap_count = 0;
  };
  synthesis::LutHeader& header() { return *reinterpret_cast<synthesis::LutHeader*>(memory_.data()); }
  std::span<synthesis::LutBlock> blocks();

  SourceGrid grid_;
  std::span<std::byte> memory_;
  std::array<Part, kMostParts> parts_;
};

}  // namespace svchain::bowl
