#pragma once
// What a block samples of frames in YUV, turned to BGR first: only those pixels, while the block is computed,
// into memory so small that it stays in the second-level cache. No frame is ever converted as a whole. Owns
// its memory, a quarter of a megabyte, and makes no more; one thread.

#include <span>

#include "algorithms/synthesis/stages.h"

namespace svchain::synthesis {

class ConvertedBoxes {
 public:
  /// A new block begins: boxes handed out so far are gone.
  void clear() { used_ = 0; }
  /// A box to sample from, of which `rows` are needed: the frame's own where it is BGR, or where it has no
  /// rows or is too large to be converted; else one of this object's.
  FrameBox box(const colour::Picture& frame, const LutSource& source, std::span<const LutRow> rows,
               const Stages& stages);

 private:
  static constexpr size_t kBytes = 256 * 1024;
  size_t used_ = 0;
  alignas(kLargestVector) uint8_t bytes_[kBytes];
};

}  // namespace svchain::synthesis
