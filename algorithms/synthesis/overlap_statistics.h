#pragma once
// What synthesis tells photometric alignment about a frame: for every 40x40 block of the composite and pair
// of cameras blended in it, how bright either camera is there, before falloff and tone mapping. Gathered in
// passing, so that no frame is read twice. One flat block of memory, because it travels between cores in a
// pool buffer: this header, with its entries right behind it. The memory's owner frees it; one writer, then
// any readers.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

#include "algorithms/geometry/view.h"
#include "algorithms/synthesis/tone_mapping.h"

namespace svchain::synthesis {

/// One camera's samples in one block, per channel b, g, r.
struct BlockSamples {
  std::array<uint32_t, kChannels> sum;
  std::array<uint32_t, kChannels> sum_of_squares;
  std::array<uint32_t, kChannels> clipped;  // samples <= 2 or >= 253

  bool operator==(const BlockSamples&) const = default;
};

/// One block's overlap of two neighbours, clockwise: the pixels that show both of them.
struct OverlapBlock {
  uint16_t camera_a;
  uint16_t camera_b;
  uint32_t block;   // index in the LUT
  uint32_t pixels;  // 1 to 1600
  float q2_a;       // where in its image camera a sees the block: mean q^2 (geometric_lut.h, LutOverlap)
  float q2_b;
  BlockSamples a;
  BlockSamples b;
};

struct OverlapStatistics {
  uint32_t capacity;
  uint32_t count;

  /// Memory that is enough for any rig at this view.
  static size_t bytes_for(const geometry::View& view);
  /// Empty statistics at the front of `memory` (aligned to 4 bytes), with as many entries as fit.
  static OverlapStatistics* create(std::span<std::byte> memory);

  std::span<const OverlapBlock> blocks() const { return {entries(), count}; }
  void clear() { count = 0; }
  /// Appends an entry; there must be room.
  void add(const OverlapBlock& block);
  /// Makes so many entries, of any content, for `put` to write; there must be room. Different threads may put
  /// different entries at the same time.
  void expect(uint32_t entries) { count = entries; }
  void put(uint32_t index, const OverlapBlock& block);

 private:
  const OverlapBlock* entries() const { return reinterpret_cast<const OverlapBlock*>(this + 1); }
};

static_assert(std::is_trivially_copyable_v<OverlapStatistics> && std::is_trivially_copyable_v<OverlapBlock>);

}  // namespace svchain::synthesis
