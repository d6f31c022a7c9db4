#include "algorithms/synthesis/overlap_statistics.h"

#include <new>
#include <stdexcept>

#include "algorithms/synthesis/geometric_lut.h"

namespace svchain::synthesis {
namespace {

constexpr size_t kPairs = 4;  // of four cameras, each with its neighbour

}  // namespace

size_t OverlapStatistics::bytes_for(const geometry::View& view) {
  return sizeof(OverlapStatistics) + block_count(view.size_px) * kPairs * sizeof(OverlapBlock);
}

OverlapStatistics* OverlapStatistics::create(std::span<std::byte> memory) {
  if (memory.size() < sizeof(OverlapStatistics))
    throw std::invalid_argument("overlap statistics: the memory is smaller than their header");
  const size_t room = (memory.size() - sizeof(OverlapStatistics)) / sizeof(OverlapBlock);
  return new (memory.data()) OverlapStatistics{static_cast<uint32_t>(room), 0};
}

void OverlapStatistics::add(const OverlapBlock& block) {
  put(count++, block);
}

void OverlapStatistics::put(uint32_t index, const OverlapBlock& block) {
  const_cast<OverlapBlock*>(entries())[index] = block;
}

}  // namespace svchain::synthesis
