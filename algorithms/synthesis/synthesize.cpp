#include "algorithms/synthesis/synthesize.h"

#include <cstring>
#include <opencv2/core.hpp>
#include <stdexcept>
#include <string>

#include "algorithms/synthesis/fixed_point.h"

namespace svchain::synthesis {
namespace {

/// Samples of a span, channel by channel, so that what follows runs over plain arrays.
struct Samples {
  uint8_t channel[kChannels][kBlockSize];
};

struct Source {
  const uint8_t* origin = nullptr;  // top left pixel of the box, null for a missing frame
  size_t pitch = 0;
  const std::array<ToneMapping::Curve, kChannels>* curves = nullptr;
  bool has_falloff = false;
  int32_t a1 = 0, a2 = 0;
  int32_t centre_x = 0, centre_y = 0;  // of the lens, 1/32 px from the box's top left pixel
  RadialScale radial = {};
};

void sample(const Source& source, const uint32_t* entries, int count, Samples& samples) {
  if (!source.origin) {
    std::memset(&samples, 0, sizeof samples);
    return;
  }
  for (int i = 0; i < count; ++i) {
    const uint32_t x = entry_x(entries[i]), y = entry_y(entries[i]);
    const uint8_t* upper =
        source.origin + (y >> kFractionBits) * source.pitch + (x >> kFractionBits) * kChannels;
    const uint8_t* lower = upper + source.pitch;
    const uint32_t fx = x % kOnePixel, fy = y % kOnePixel;
    for (int c = 0; c < kChannels; ++c)
      samples.channel[c][i] =
          bilinear(upper[c], upper[c + kChannels], lower[c], lower[c + kChannels], fx, fy);
  }
}

void undo_falloff(const Source& source, const uint32_t* entries, int count, Samples& samples) {
  int32_t factors[kBlockSize];
  for (int i = 0; i < count; ++i) {
    const auto x = static_cast<int32_t>(entry_x(entries[i])), y = static_cast<int32_t>(entry_y(entries[i]));
    factors[i] =
        radial_factor(source.a1, source.a2, source.radial.q2(x - source.centre_x, y - source.centre_y));
  }
  for (int c = 0; c < kChannels; ++c)
    for (int i = 0; i < count; ++i) samples.channel[c][i] = unfade(samples.channel[c][i], factors[i]);
}

void tone_map(const Source& source, const uint32_t* entries, int count, Samples& samples) {
  if (source.has_falloff) undo_falloff(source, entries, count, samples);
  for (int c = 0; c < kChannels; ++c) {
    const ToneMapping::Curve& curve = (*source.curves)[c];
    for (int i = 0; i < count; ++i) samples.channel[c][i] = curve[samples.channel[c][i]];
  }
}

void blend(const Samples& a, const Samples& b, const uint8_t* weights, int count, Samples& out) {
  for (int c = 0; c < kChannels; ++c)
    for (int i = 0; i < count; ++i)
      out.channel[c][i] = synthesis::blend(a.channel[c][i], b.channel[c][i], weights[i]);
}

void store(const Samples& samples, int count, uint8_t* out) {
  for (int i = 0; i < count; ++i)
    for (int c = 0; c < kChannels; ++c) *out++ = samples.channel[c][i];
}

void gather(const Samples& samples, int count, BlockSamples& into) {
  for (int c = 0; c < kChannels; ++c) {
    uint32_t sum = 0, sum_of_squares = 0, clipped = 0;
    for (int i = 0; i < count; ++i) {
      const uint32_t v = samples.channel[c][i];
      sum += v;
      sum_of_squares += v * v;
      clipped += is_clipped(samples.channel[c][i]);
    }
    into.sum[c] += sum;
    into.sum_of_squares[c] += sum_of_squares;
    into.clipped[c] += clipped;
  }
}

/// One block after the other; borrows everything.
class Kernel {
 public:
  Kernel(const GeometricLut& lut, std::span<const cv::Mat> frames, const ToneMapping& tone_mapping,
         cv::Mat& out, OverlapStatistics* statistics)
      : lut_(lut), frames_(frames), tone_mapping_(tone_mapping), out_(out), statistics_(statistics) {}

  void run(const LutBlock& block, uint32_t index) {
    open(block);
    const uint32_t* entries = lut_.entries(block);
    const uint8_t* weights = lut_.weights(block);
    const uint8_t* background = lut_.background(block);
    for (const LutSpan& span : lut_.spans(block)) {
      uint8_t* out = out_.ptr(block.y + span.row) + (block.x + span.start) * kChannels;
      const int count = span.count;
      switch (span.kind) {
        case SpanKind::kBlack:
          std::memset(out, 0, count * kChannels);
          break;
        case SpanKind::kBackground:
          std::memcpy(out, background, count * kChannels);
          background += count * kChannels;
          break;
        case SpanKind::kCamera:
          show_one(sources_[span.first], entries, count, out);
          entries += count;
          break;
        case SpanKind::kBlend:
          show_both(span, entries, weights, out);
          entries += 2 * count;
          weights += count;
          break;
      }
    }
    if (statistics_) close(block, index);
  }

 private:
  void open(const LutBlock& block) {
    for (uint32_t i = 0; i < block.source_count; ++i) {
      sources_[i] = source_of(block.sources[i]);
      overlaps_[i] = {};
    }
  }

  Source source_of(const LutSource& box) const {
    const LutHeader& header = lut_.header();
    const cv::Mat& frame = frames_[box.camera];
    Source source;
    source.origin = frame.empty() ? nullptr : frame.ptr(box.y) + box.x * kChannels;
    source.pitch = frame.empty() ? 0 : frame.step[0];
    source.curves = &tone_mapping_.curves[box.camera];
    source.has_falloff = tone_mapping_.has_falloff(box.camera);
    if (!source.has_falloff) return source;
    source.a1 = tone_mapping_.falloff[box.camera][0];
    source.a2 = tone_mapping_.falloff[box.camera][1];
    source.centre_x = header.lens_centre[box.camera][0] - box.x * int{kOnePixel};
    source.centre_y = header.lens_centre[box.camera][1] - box.y * int{kOnePixel};
    source.radial = RadialScale::of(header.image_size_px[box.camera][0]);
    return source;
  }

  void show_one(const Source& source, const uint32_t* entries, int count, uint8_t* out) {
    sample(source, entries, count, first_);
    tone_map(source, entries, count, first_);
    store(first_, count, out);
  }

  void show_both(const LutSpan& span, const uint32_t* entries, const uint8_t* weights, uint8_t* out) {
    const int count = span.count;
    const Source& a = sources_[span.first];
    const Source& b = sources_[span.second];
    sample(a, entries, count, first_);
    sample(b, entries + count, count, second_);
    if (statistics_) {
      OverlapBlock& overlap = overlaps_[span.first];
      overlap.pixels += span.count;
      overlap.camera_b = span.second;  // its source as yet
      gather(first_, count, overlap.a);
      gather(second_, count, overlap.b);
    }
    tone_map(a, entries, count, first_);
    tone_map(b, entries + count, count, second_);
    blend(first_, second_, weights, count, first_);
    store(first_, count, out);
  }

  /// A pair of neighbours is known by its clockwise first, so there is at most one overlap per source.
  void close(const LutBlock& block, uint32_t index) {
    for (uint32_t i = 0; i < block.source_count; ++i) {
      OverlapBlock& overlap = overlaps_[i];
      if (overlap.pixels == 0) continue;
      overlap.camera_a = block.sources[i].camera;
      overlap.camera_b = block.sources[overlap.camera_b].camera;
      overlap.block = index;
      overlap.q2_a = block.overlaps[i].q2_first;
      overlap.q2_b = block.overlaps[i].q2_second;
      statistics_->add(overlap);
    }
  }

  const GeometricLut& lut_;
  std::span<const cv::Mat> frames_;
  const ToneMapping& tone_mapping_;
  cv::Mat& out_;
  OverlapStatistics* statistics_;
  std::array<Source, 4> sources_;
  std::array<OverlapBlock, 4> overlaps_;
  Samples first_;
  Samples second_;
};

void require(bool condition, const char* what) {
  if (!condition) throw std::invalid_argument(std::string("synthesis: ") + what);
}

void check(const LutHeader& header, std::span<const cv::Mat> frames, const cv::Mat& out,
           const OverlapStatistics* statistics) {
  require(frames.size() == header.camera_count, "expected as many frames as the LUT has cameras");
  for (size_t i = 0; i < frames.size(); ++i)
    require(
        frames[i].empty() || (frames[i].type() == CV_8UC3 && frames[i].cols == header.image_size_px[i][0] &&
                              frames[i].rows == header.image_size_px[i][1]),
        "a frame is not BGR of the size that the LUT was made for");
  require(out.type() == CV_8UC3 && out.cols == header.width && out.rows == header.height,
          "the output is not BGR of the view's size");
  require(!statistics || statistics->capacity >= header.overlap_count, "the statistics' memory is too small");
}

}  // namespace

void synthesize(const GeometricLut& lut, std::span<const cv::Mat> frames, const ToneMapping& tone_mapping,
                cv::Mat& out, OverlapStatistics* statistics) {
  check(lut.header(), frames, out, statistics);
  if (statistics) statistics->clear();
  Kernel kernel(lut, frames, tone_mapping, out, statistics);
  uint32_t index = 0;
  for (const LutBlock& block : lut.blocks()) kernel.run(block, index++);
}

}  // namespace svchain::synthesis
