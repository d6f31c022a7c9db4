#pragma once
// What one frame's overlap statistics tell about the cameras' tone curves: the blocks that may be believed,
// each as a few parts of known brightness, so that the mean of any curve over the block can be told. A block
// is its clipped pixels, which are as bright as a pixel can get, and the rest, half of it a standard
// deviation darker and half a standard deviation brighter than the rest's mean. Made anew with every frame;
// allocates only when constructed. One thread.

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "algorithms/photometric/tone_curves.h"
#include "algorithms/synthesis/overlap_statistics.h"

namespace svchain::photometric {

/// One camera's channel in one block.
struct Brightness {
  struct Part {
    double share = 0;      // of the pixels
    double log_level = 0;  // ln of grey levels
  };
  /// How ln of the mean changes.
  struct Derivatives {
    ToneCurves::Knots by_knots;
    double by_log_factor;
  };
  std::array<Part, 3> parts;
  int count = 0;

  /// ln of the mean after levels were multiplied by a factor, clamped to 255 and sent through the curve: as
  /// synthesis does it.
  double log_mean(const ToneCurves::Knots& knots, double log_factor,
                  Derivatives* derivatives = nullptr) const;
};

struct SharedBlock {
  std::array<uint16_t, 2> cameras;                                         // clockwise first, second
  std::array<double, 2> q2;                                                // where they see it
  std::array<std::array<Brightness, synthesis::kChannels>, 2> brightness;  // [camera][channel]
  std::array<double, synthesis::kChannels> sigma;  // of ln(first / second), by what is known beforehand
  double weight = 0;                               // 0..1, by its size
  double clipped = 0;                              // largest share

  bool is_clipped() const { return clipped > 0.05; }
  /// ln of the mean of one of the two after the curves, grey levels.
  double log_level(const ToneCurves& curves, size_t side, size_t channel) const;
  /// ln(first / second) after the curves.
  double log_ratio(const ToneCurves& curves, size_t channel) const {
    return log_level(curves, 0, channel) - log_level(curves, 1, channel);
  }
};

/// Blocks that were not believed, by reason.
struct Rejections {
  size_t small = 0;          // fewer than 50 pixels
  size_t dark = 0;           // mean below 6 grey levels in a channel
  size_t saturated = 0;      // of a camera that shows hardly anything but white
  size_t contradicting = 0;  // one camera much brighter, or against what all others say: not the same thing
};

class Evidence {
 public:
  /// Enough for statistics of so many blocks; more are left out.
  explicit Evidence(size_t most_blocks);

  /// Entries that name cameras from `cameras` upwards are left out.
  void take(const synthesis::OverlapStatistics& statistics, size_t cameras);

  std::span<const SharedBlock> blocks() const { return blocks_; }
  const Rejections& rejections() const { return rejections_; }
  /// Whether any block shows the camera.
  bool shows(size_t camera) const { return shown_[camera]; }

 private:
  void add(const synthesis::OverlapBlock& block);
  void leave_out_white_cameras();

  std::vector<SharedBlock> blocks_;
  Rejections rejections_;
  std::array<bool, synthesis::kMaxCameras> shown_ = {};
};

}  // namespace svchain::photometric
