#pragma once
// Photometric alignment by one gain per camera and channel (the paper's "Photometric alignment", with the
// simplest tone mapping functions): what two cameras show of the same ground shall be equally bright. For
// each channel, jointly for all cameras, the squared differences over all overlap blocks are minimised,
//   sum n (g_a m_a - g_b m_b)^2,
// m being the block's means and n its pixels; to first order, and free of scale, this is
//   sum n m_a m_b (ln g_a m_a - ln g_b m_b)^2.
// In logarithms the trivial solution (all gains 0) does not exist, and what the overlaps leave open, the
// common level, stays where it was: the geometric mean of gains that overlaps connect does not change.

#include <array>
#include <cstddef>

#include "algorithms/synthesis/overlap_statistics.h"
#include "algorithms/synthesis/tone_mapping.h"

namespace svchain::photometric {

struct Gains {
  std::array<std::array<double, synthesis::kChannels>, synthesis::kMaxCameras>
      value;  // [camera][b, g, r], above 0
  size_t blocks_used = 0;
  size_t blocks_rejected = 0;

  /// All 1, from no blocks.
  static Gains identity();
};

/// Estimates the gains from one frame's statistics. Blocks that are clipped, too dark or too small, and those
/// that contradict the others of their pair of cameras or the joint solution (something standing up, a
/// reflection) are rejected, in all channels. A camera without a usable overlap keeps its gain of `last`.
/// Allocates nothing; entries naming cameras from `cameras` (at most 8) upwards are rejected.
Gains estimate_gains(const synthesis::OverlapStatistics& statistics, size_t cameras,
                     const Gains& last = Gains::identity());

/// Every value times its camera's gain, rounded, at most 255: monotone curves.
synthesis::ToneMapping tone_mapping(const Gains& gains);

}  // namespace svchain::photometric
