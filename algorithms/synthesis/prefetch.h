#pragma once
// The paper's ping-pong transfer as a machine with caches does it: what the next block reads of the cameras'
// frames and writes of the composite is asked for while this one is computed, a share at a time, so that the
// memory works beside the arithmetic and neither waits. It goes to the second-level cache, as the first holds
// little more than one block. Changes nothing; borrows everything; one thread.

#include <cstddef>
#include <span>

#include "algorithms/colour/picture.h"
#include "algorithms/synthesis/geometric_lut.h"

namespace svchain::synthesis {

class Prefetch {
 public:
  Prefetch(const GeometricLut& lut, std::span<const colour::Picture> frames, const colour::Picture& out)
      : lut_(lut), frames_(frames), out_(out) {}

  /// From now on a block (none: nothing) is asked for, in shares of `work`, whatever it counts.
  void begin(const LutBlock* block, size_t work);
  /// So much more of the work is about to be done.
  void advance(size_t work);
  /// Whatever is left.
  void finish();

 private:
  void ask_until(size_t line);
  void ask_source(const LutSource& source, const LutRow* rows, size_t begin, size_t end) const;
  void ask_target(size_t begin, size_t end) const;

  const GeometricLut& lut_;
  std::span<const colour::Picture> frames_;
  const colour::Picture& out_;
  const LutBlock* block_ = nullptr;
  size_t work_ = 0, done_ = 0;
  size_t lines_ = 0, asked_ = 0;  // rows of the block's sources, then those of the block itself
};

}  // namespace svchain::synthesis
