#include "algorithms/synthesis/synthesize.h"

#include <cstring>
#include <stdexcept>
#include <string>

#include "algorithms/colour/convert.h"
#include "algorithms/synthesis/fixed_point.h"
#include "algorithms/synthesis/sampling.h"

namespace svchain::synthesis {
namespace {

using colour::Picture;
using colour::PixelFormat;

struct Source {
  FrameBox frame;
  const std::array<ToneMapping::Curve, kChannels>* curves = nullptr;
  bool has_falloff = false;
  int32_t a1 = 0, a2 = 0;
  int32_t centre_x = 0, centre_y = 0;  // of the lens, 1/32 px from the box's top left pixel
  RadialScale radial = {};
};

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
  Kernel(const GeometricLut& lut, std::span<const Picture> frames, const ToneMapping& tone_mapping,
         const Picture& out, OverlapStatistics* statistics)
      : lut_(lut), frames_(frames), tone_mapping_(tone_mapping), out_(out), statistics_(statistics) {}

  void run(const LutBlock& block, uint32_t index) {
    open(block);
    const Picture target = bgr_target(block);
    const uint32_t* entries = lut_.entries(block);
    const uint8_t* weights = lut_.weights(block);
    const uint8_t* background = lut_.background(block);
    for (const LutSpan& span : lut_.spans(block)) {
      uint8_t* out = target.pixels + span.row * target.pitch_bytes + span.start * kChannels;
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
    if (out_.format == PixelFormat::kNv12) colour::yuv_from_bgr(target, nv12_target(block));
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
    Source source;
    source.frame = FrameBox(frames_[box.camera], box);
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

  /// Where a block's BGR goes: into the composite, or to be made NV12 there while it is in the cache.
  Picture bgr_target(const LutBlock& block) {
    Picture target{PixelFormat::kBgr8, {}, block.width, block.height, sizeof tile_[0], tile_[0], nullptr};
    if (out_.format == PixelFormat::kNv12) return target;
    target.pitch_bytes = out_.pitch_bytes;
    target.pixels = out_.pixels + block.y * out_.pitch_bytes + block.x * kChannels;
    return target;
  }

  /// A block begins at an even pixel, so it has whole groups of chroma.
  Picture nv12_target(const LutBlock& block) const {
    Picture target = out_;
    target.width_px = block.width;
    target.height_px = block.height;
    target.pixels += block.y * out_.pitch_bytes + block.x;
    target.chroma += block.y / 2 * out_.pitch_bytes + block.x;
    return target;
  }

  void show_one(const Source& source, const uint32_t* entries, int count, uint8_t* out) {
    source.frame.sample(entries, count, first_);
    tone_map(source, entries, count, first_);
    store(first_, count, out);
  }

  void show_both(const LutSpan& span, const uint32_t* entries, const uint8_t* weights, uint8_t* out) {
    const int count = span.count;
    const Source& a = sources_[span.first];
    const Source& b = sources_[span.second];
    a.frame.sample(entries, count, first_);
    b.frame.sample(entries + count, count, second_);
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
  std::span<const Picture> frames_;
  const ToneMapping& tone_mapping_;
  const Picture& out_;
  OverlapStatistics* statistics_;
  std::array<Source, 4> sources_;
  std::array<OverlapBlock, 4> overlaps_;
  Samples first_;
  Samples second_;
  uint8_t tile_[kBlockSize][kBlockSize * kChannels];
};
static_assert(kBlockSize % 2 == 0);

void require(bool condition, const char* what) {
  if (!condition) throw std::invalid_argument(std::string("synthesis: ") + what);
}

bool fits(const Picture& picture, int width_px, int height_px) {
  return picture.width_px == width_px && picture.height_px == height_px &&
         colour::has_whole_groups(picture.format, width_px, height_px);
}

void check(const LutHeader& header, std::span<const Picture> frames, const Picture& out,
           const OverlapStatistics* statistics) {
  require(frames.size() == header.camera_count, "expected as many frames as the LUT has cameras");
  for (size_t i = 0; i < frames.size(); ++i)
    require(frames[i].empty() || fits(frames[i], header.image_size_px[i][0], header.image_size_px[i][1]),
            "a frame is not of the size that the LUT was made for, or has not the even size of its format");
  require(!out.empty() && out.format != PixelFormat::kYuyv, "the output is neither BGR nor NV12");
  require(out.width_px == header.width && out.height_px == header.height,
          "the output is not of the view's size");
  require(colour::has_whole_groups(out.format, out.width_px, out.height_px),
          "NV12 needs a view of even width and height");
  require(!statistics || statistics->capacity >= header.overlap_count, "the statistics' memory is too small");
}

Picture checked_picture(const cv::Mat& bgr) {
  require(bgr.empty() || bgr.type() == CV_8UC3, "a cv::Mat is not BGR");
  return colour::bgr_picture(bgr);
}

}  // namespace

void synthesize(const GeometricLut& lut, std::span<const Picture> frames, const ToneMapping& tone_mapping,
                const Picture& out, OverlapStatistics* statistics) {
  check(lut.header(), frames, out, statistics);
  if (statistics) statistics->clear();
  Kernel kernel(lut, frames, tone_mapping, out, statistics);
  uint32_t index = 0;
  for (const LutBlock& block : lut.blocks()) kernel.run(block, index++);
}

void synthesize(const GeometricLut& lut, std::span<const cv::Mat> frames, const ToneMapping& tone_mapping,
                cv::Mat& out, OverlapStatistics* statistics) {
  std::array<Picture, kMaxCameras> pictures;
  require(frames.size() <= pictures.size(), "more frames than cameras there can be");
  for (size_t i = 0; i < frames.size(); ++i) pictures[i] = checked_picture(frames[i]);
  synthesize(lut, std::span<const Picture>(pictures.data(), frames.size()), tone_mapping,
             checked_picture(out), statistics);
}

}  // namespace svchain::synthesis
