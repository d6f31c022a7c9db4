#pragma once
// What a kernel is made of: the steps that synthesis takes with some pixels of one region of a block, each
// running over plain lists. Internal to synthesis; pure functions over the caller's memory.

#include <cstddef>
#include <cstdint>
#include <span>

#include "algorithms/synthesis/fixed_point.h"
#include "algorithms/synthesis/frame_box.h"
#include "algorithms/synthesis/geometric_lut.h"
#include "algorithms/synthesis/overlap_statistics.h"
#include "algorithms/synthesis/tone_mapping.h"

namespace svchain::synthesis {

inline constexpr size_t kLargestVector = 64;  // bytes
/// So many pixels of a region go through all stages at a time: what one leaves for the next stays near.
inline constexpr size_t kStagePixels = 320;
static_assert(kStagePixels % kLargestVector == 0 && kStagePixels % kBlockSize == 0);

/// Samples, channel by channel (b, g, r). Stages may also write what lies behind `count` up to the next
/// multiple of 64; what is there has no meaning.
struct Samples {
  alignas(kLargestVector) uint8_t channel[kChannels][kStagePixels];
};

/// How a source's falloff is undone.
struct Falloff {
  int32_t a1, a2;
  int32_t centre_x, centre_y;  // of the lens, 1/32 px from the box's top left pixel
  RadialScale radial;
};

/// A camera's tone curves, in whatever form a kernel looks them up fastest.
struct ToneTables {
  alignas(kLargestVector) uint8_t channel[kChannels][256];
};

/// Samples as pixels of one format.
struct Packing {
  /// One behind the other; may write up to the next multiple of 64 pixels.
  void (*list)(const Samples& samples, size_t count, uint8_t* to);
  /// Rows of kBlockSize, `pitch` bytes apart; writes nothing else.
  void (*rows)(const Samples& samples, size_t rows, uint8_t* to, size_t pitch);
};

struct Stages {
  /// Turns the pixels of a YUV box that `rows` name to b g r, row by row `pitch` bytes apart; `bgr` is the
  /// box's first pixel. May also write one pixel before and 64 behind each run of a row.
  void (*turn_to_bgr)(const FrameBox& yuv, std::span<const LutRow> rows, uint8_t* bgr, size_t pitch);
  /// Samples at entries of the LUT, black where there is no frame. Reads no byte before the frame's first or
  /// behind its last, but maybe some between its rows.
  void (*sample)(const FrameBox& box, const uint32_t* entries, size_t count, Samples& samples);
  void (*undo_falloff)(const Falloff& falloff, const uint32_t* entries, size_t count, Samples& samples);
  /// Adds what the samples sum up to.
  void (*add)(const Samples& samples, size_t count, BlockSamples& into);
  ToneTables (*tone_tables)(const std::array<ToneMapping::Curve, kChannels>& curves);
  void (*tone_map)(const ToneTables& tables, size_t count, Samples& samples);
  /// Blends b into a. `weights` are aligned and padded as samples are.
  void (*blend)(Samples& a, const Samples& b, const uint8_t* weights, size_t count);
  Packing bgr, bgrx;
};

/// The reference.
extern const Stages kPortableStages;

}  // namespace svchain::synthesis
