#pragma once
// Which links of a core should be looked at, because something has changed for them: marks for those that
// change it on the same core, bells for those on others.

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "ipc/cache_line.h"
#include "ipc/doorbell.h"

namespace svchain {

/// The last bell of a core stands for all of its links. Where there are more links than bells they share
/// them.
constexpr int kBellOfAll = ipc::Doorbell::kBells - 1;
constexpr int bell_of(int runner) {
  return runner % kBellOfAll;
}

/// One mark per link of a core. Its core's thread only.
class Attention {
 public:
  static constexpr size_t kWordBits = 64;

  explicit Attention(int runners = 0) : lines_(static_cast<size_t>(runners) / kLineBits + 1) {}
  void mark(int runner) { word_of(runner) |= bit(runner); }
  void clear(int runner) { word_of(runner) &= ~bit(runner); }
  /// Words of marks, the first link in the lowest bit of the first word.
  size_t words() const { return lines_.size() * kLineWords; }
  uint64_t word(size_t w) const { return lines_[w / kLineWords].words[w % kLineWords]; }

 private:
  static constexpr size_t kLineWords = ipc::kCacheLine / sizeof(uint64_t), kLineBits = kLineWords * kWordBits;
  /// No cache line has marks of two cores.
  struct alignas(ipc::kCacheLine) Line {
    std::array<uint64_t, kLineWords> words{};
  };

  uint64_t& word_of(int runner) {
    const auto w = static_cast<size_t>(runner) / kWordBits;
    return lines_[w / kLineWords].words[w % kLineWords];
  }
  static uint64_t bit(int runner) { return uint64_t{1} << (static_cast<size_t>(runner) % kWordBits); }

  std::vector<Line> lines_;
};

}  // namespace svchain
