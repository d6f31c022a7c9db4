#pragma once
// Photometric alignment over time (the paper's "Photometric alignment"): the statistics of frame n set the
// tone mapping of frame n + 1. The first frame that tells anything is followed at once, later ones smoothly,
// with what earlier frames told kept in mind; a camera that exposes anew is caught up with in a few frames,
// alone. Where a frame tells nothing, the last curves stay. The geometric mean of the cameras' curves is the
// identity at the start, and slowly becomes it again after cameras have changed: so exposure, colour and
// contrast of the whole stay what they are. Deterministic, allocates nothing after construction; one thread.

#include <array>
#include <cstdint>
#include <vector>

#include "algorithms/photometric/evidence.h"
#include "algorithms/photometric/joint_fit.h"
#include "algorithms/photometric/tone_curves.h"

namespace svchain::photometric {

struct AlignmentSettings {
  size_t cameras = 4;       // 1 to 8
  size_t most_blocks = 0;   // entries that statistics may have
  double smoothing = 0.02;  // share of the way to a new estimate that is gone with every frame, above 0 to 1
  bool falloff = true;      // radial falloff is undone where the overlaps show it
};

/// What one overlap showed in the last frame: means over its blocks and channels, grey levels.
struct OverlapDifference {
  size_t camera_a = 0, camera_b = 0;
  size_t blocks = 0;             // that were believed
  double before = 0, after = 0;  // |a - b| without correction and with it
};

class PhotometricAlignment {
 public:
  /// Throws std::invalid_argument where a setting is out of range.
  explicit PhotometricAlignment(const AlignmentSettings& settings);

  /// Takes the statistics of a frame (before falloff and tone mapping, so that what was mapped how does not
  /// matter) and returns what the next frame is to be mapped with. Valid until the next call.
  const synthesis::ToneMapping& update(const synthesis::OverlapStatistics& statistics);

  const synthesis::ToneMapping& tone_mapping() const { return tone_mapping_; }
  const ToneCurves& curves() const { return curves_; }

  /// Of the last frame.
  size_t blocks_used() const { return evidence_.blocks().size() - contradicting_; }
  Rejections rejections() const;
  std::vector<OverlapDifference> differences() const;
  /// Frames so far, and how many of them told nothing, so that the last curves stayed.
  uint64_t frames() const { return frames_; }
  uint64_t frames_held() const { return frames_held_; }

 private:
  void start();
  void follow();
  void shift_changed_cameras();
  void return_to_common_level();

  AlignmentSettings settings_;
  Evidence evidence_;
  JointFit fit_;
  std::vector<double> scratch_;
  bool started_ = false;
  size_t contradicting_ = 0;  // in the last frame, by the fit
  uint64_t frames_ = 0, frames_held_ = 0;
  ToneCurves curves_;
  synthesis::ToneMapping tone_mapping_;
};

}  // namespace svchain::photometric
