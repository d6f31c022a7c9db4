#pragma once
// Gains over time: the first frame's estimate is taken at once, later ones are followed smoothly, so that the
// picture does not flicker when cameras expose anew. Deterministic, allocates nothing after construction; one
// thread.

#include "algorithms/photometric/gains.h"

namespace svchain::photometric {

class PhotometricAlignment {
 public:
  /// `smoothing` is the share (0 to 1, above 0) of the way to the new estimate that the gains' logarithms go
  /// per frame. Throws std::invalid_argument where it or the number of cameras (1 to 8) is out of range.
  PhotometricAlignment(size_t cameras, double smoothing);

  /// Takes the statistics of a frame (before tone mapping, so that what was mapped how does not matter) and
  /// returns what the next frame is to be mapped with. Valid until the next call.
  const synthesis::ToneMapping& update(const synthesis::OverlapStatistics& statistics);

  const synthesis::ToneMapping& tone_mapping() const { return tone_mapping_; }
  /// The gains in effect, with the numbers of blocks of the last update.
  const Gains& gains() const { return gains_; }

 private:
  size_t cameras_;
  double smoothing_;
  bool started_ = false;
  Gains gains_;
  synthesis::ToneMapping tone_mapping_;
};

}  // namespace svchain::photometric
