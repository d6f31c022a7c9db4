#pragma once
// The composite view from one frame of each camera: block by block, sample, tone-map and blend in one pass
// (the paper's "Surround view synthesis" and "DSP optimization"). With s the bilinear sample, u(s) the sample
// without its camera's falloff and T the tone curve of a camera and channel, a pixel is, exactly,
//   T_a[u(s_a)]                                   where one camera shows it
//   blend(T_a[u(s_a)], T_b[u(s_b)], weight)       where two do
//   the LUT's background, or black                elsewhere
// with `bilinear`, `unfade` and `blend` of fixed_point.h; u(s) = s where a camera has no falloff. Statistics
// are of s over the pixels that blend. Of a frame in YUV, s is what `bgr_of` (colour/yuv.h) makes of the
// bilinear samples of Y, U and V; everything behind it is the same.

#include <opencv2/core/mat.hpp>
#include <span>

#include "algorithms/colour/picture.h"
#include "algorithms/synthesis/geometric_lut.h"
#include "algorithms/synthesis/kernel.h"
#include "algorithms/synthesis/overlap_statistics.h"
#include "algorithms/synthesis/tone_mapping.h"

namespace svchain::synthesis {

/// `frames`: one per camera of the LUT, each in its own format, rows of any pitch; an empty one stands for a
/// black picture. `out` is BGR or NV12 of the view's size and is written completely, NV12 as `yuv_from_bgr`
/// would make it of the BGR; `statistics` (may be null) are overwritten. Throws std::invalid_argument, before
/// the first pixel, where a size or type does not fit or the processor does not run the kernel. Allocates
/// nothing, and reads no byte outside the frames. Any thread, as long as no other writes the same output.
void synthesize(const GeometricLut& lut, std::span<const colour::Picture> frames,
                const ToneMapping& tone_mapping, const colour::Picture& out, OverlapStatistics* statistics,
                Kernel kernel = best_kernel());

/// The same in parts, which different threads may do at the same time and in any order: together they write
/// the same bytes, whatever their number. Statistics must expect the LUT's overlaps beforehand
/// (OverlapStatistics::expect, header().overlap_count).
struct Part {
  int index = 0;
  int count = 1;
};
void synthesize_part(const Part& part, const GeometricLut& lut, std::span<const colour::Picture> frames,
                     const ToneMapping& tone_mapping, const colour::Picture& out,
                     OverlapStatistics* statistics, Kernel kernel);

/// The whole for BGR (CV_8UC3) on both sides.
void synthesize(const GeometricLut& lut, std::span<const cv::Mat> frames, const ToneMapping& tone_mapping,
                cv::Mat& out, OverlapStatistics* statistics, Kernel kernel = best_kernel());

}  // namespace svchain::synthesis
