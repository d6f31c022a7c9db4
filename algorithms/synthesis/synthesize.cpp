#include "algorithms/synthesis/synthesize.h"

#include <algorithm>
#include <cstring>
#include <optional>
#include <stdexcept>
#include <string>

#include "algorithms/colour/convert.h"
#include "algorithms/synthesis/converted_boxes.h"
#include "algorithms/synthesis/prefetch.h"
#include "algorithms/synthesis/stages.h"
#include "algorithms/synthesis/vector_stages.h"

namespace svchain::synthesis {
namespace {

using colour::Picture;
using colour::PixelFormat;

struct Source {
  FrameBox frame;
  const ToneTables* tone = nullptr;
  std::optional<Falloff> falloff;
};

constexpr size_t kBlockPixels = size_t{kBlockSize} * kBlockSize;
/// A block's, and what the last portion may write behind.
constexpr size_t kPackedPixels = kBlockPixels + kLargestVector;
constexpr size_t kMostBytesPerPx = 4;

/// Calls visit(at, count) for one portion of a region after the other.
template <class Visit>
void in_portions(size_t pixels, Visit visit) {
  for (size_t at = 0; at < pixels; at += kStagePixels) visit(at, std::min(kStagePixels, pixels - at));
}

/// One block after the other; borrows everything.
class Synthesis {
 public:
  Synthesis(const GeometricLut& lut, std::span<const Picture> frames, const ToneMapping& tone_mapping,
            const Picture& out, OverlapStatistics* statistics, Kernel kernel)
      : lut_(lut),
        frames_(frames),
        tone_mapping_(tone_mapping),
        out_(out),
        statistics_(statistics),
        stages_(kernel == Kernel::kPortable ? kPortableStages : *vector_stages(kernel)),
        packing_(out.format == PixelFormat::kBgrx8 ? stages_.bgrx : stages_.bgr),
        px_bytes_(out.format == PixelFormat::kBgrx8 ? kMostBytesPerPx : kChannels),
        prefetch_(lut, frames, out) {
    for (size_t i = 0; i < frames.size(); ++i) tone_[i] = stages_.tone_tables(tone_mapping.curves[i]);
  }

  /// `next`, if any, is the block whose turn comes then.
  void run(const LutBlock& block, uint32_t index, const LutBlock* next) {
    open(block);
    prefetch_.begin(next, block.entry_count);
    const uint32_t* entries = lut_.entries(block);
    const uint8_t* weights = lut_.weights(block);
    const uint8_t* background = lut_.background(block);
    const LutSpan* spans = lut_.spans(block).data();
    for (const LutRegion& region : lut_.regions(block)) {
      const uint8_t* pixels = packed_;
      whole_ = region.pixels == kBlockPixels && region.kind != RegionKind::kBackground;
      switch (region.kind) {
        case RegionKind::kBlack:
          show_black(region);
          break;
        case RegionKind::kBackground:
          pixels = packed(background, region.pixels);
          background += region.pixels * kChannels;
          break;
        case RegionKind::kCamera:
          show_one(region, entries);
          break;
        case RegionKind::kBlend:
          show_both(region, entries, weights);
          weights += region.pixels;
          break;
      }
      if (!whole_) spread({spans, region.span_count}, pixels);
      spans += region.span_count;
      entries += region.pixels * region.tap_count();
    }
    prefetch_.finish();
    if (out_.format == PixelFormat::kNv12) colour::yuv_from_bgr(target_, nv12_target(block));
    if (statistics_) close(block, index);
  }

 private:
  void open(const LutBlock& block) {
    target_ = packed_target(block);
    std::span<const LutRow> rows = lut_.rows(block);
    converted_.clear();
    for (uint32_t i = 0; i < block.source_count; ++i) {
      const size_t height = rows.empty() ? 0 : block.sources[i].height;
      sources_[i] = source_of(block.sources[i], rows.first(height));
      rows = rows.subspan(height);
      overlaps_[i] = {};
    }
  }

  Source source_of(const LutSource& box, std::span<const LutRow> rows) {
    const Picture& frame = frames_[box.camera];
    Source source{converted_.box(frame, box, rows, stages_), &tone_[box.camera], std::nullopt};
    if (!tone_mapping_.has_falloff(box.camera)) return source;
    const LutHeader& header = lut_.header();
    const auto [a1, a2] = tone_mapping_.falloff[box.camera];
    source.falloff = {a1, a2, header.lens_centre[box.camera][0] - box.x * int{kOnePixel},
                      header.lens_centre[box.camera][1] - box.y * int{kOnePixel},
                      RadialScale::of(header.image_size_px[box.camera][0])};
    return source;
  }

  /// Where a block's pixels go: into the composite, or to be made NV12 there while they are in the cache.
  Picture packed_target(const LutBlock& block) {
    if (out_.format == PixelFormat::kNv12)
      return {PixelFormat::kBgr8, {}, block.width, block.height, sizeof tile_[0], tile_[0], nullptr};
    Picture target = out_;
    target.width_px = block.width;
    target.height_px = block.height;
    target.pixels += block.y * out_.pitch_bytes + block.x * px_bytes_;
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

  /// A region that is all of its block goes to its place at once, any other into a list that is spread after.
  void pack(const Samples& samples, size_t at, size_t count) {
    const size_t pitch = target_.pitch_bytes;
    if (whole_)
      packing_.rows(samples, count / kBlockSize, target_.pixels + at / kBlockSize * pitch, pitch);
    else
      packing_.list(samples, count, packed_ + at * px_bytes_);
  }

  void show_black(const LutRegion& region) {
    static constexpr Samples kBlack = {};
    in_portions(region.pixels, [&](size_t at, size_t count) { pack(kBlack, at, count); });
  }

  /// b g r as they are, or with a fourth byte.
  const uint8_t* packed(const uint8_t* bgr, size_t pixels) {
    if (px_bytes_ == kChannels) return bgr;
    for (size_t i = 0; i < pixels; ++i) {
      std::memcpy(packed_ + i * px_bytes_, bgr + i * kChannels, kChannels);
      packed_[i * px_bytes_ + kChannels] = 255;
    }
    return packed_;
  }

  void show_one(const LutRegion& region, const uint32_t* entries) {
    const Source& source = sources_[region.first];
    in_portions(region.pixels, [&](size_t at, size_t count) {
      prefetch_.advance(count);
      stages_.sample(source.frame, entries + at, count, first_);
      tone_map(source, entries + at, count, first_);
      pack(first_, at, count);
    });
  }

  void show_both(const LutRegion& region, const uint32_t* first, const uint8_t* weights) {
    const Source& a = sources_[region.first];
    const Source& b = sources_[region.second];
    const uint32_t* second = first + region.pixels;
    OverlapBlock& overlap = overlaps_[region.first];
    overlap.pixels = region.pixels;
    overlap.camera_b = region.second;  // its source as yet
    in_portions(region.pixels, [&](size_t at, size_t count) {
      prefetch_.advance(2 * count);
      stages_.sample(a.frame, first + at, count, first_);
      stages_.sample(b.frame, second + at, count, second_);
      if (statistics_) {
        stages_.add(first_, count, overlap.a);
        stages_.add(second_, count, overlap.b);
      }
      tone_map(a, first + at, count, first_);
      tone_map(b, second + at, count, second_);
      std::memcpy(weights_, weights + at, count);
      stages_.blend(first_, second_, weights_, count);
      pack(first_, at, count);
    });
  }

  void tone_map(const Source& source, const uint32_t* entries, size_t count, Samples& samples) const {
    if (source.falloff) stages_.undo_falloff(*source.falloff, entries, count, samples);
    stages_.tone_map(*source.tone, count, samples);
  }

  /// From a region's list to the rows of its block.
  void spread(std::span<const LutSpan> spans, const uint8_t* pixels) const {
    for (const LutSpan& span : spans) {
      std::memcpy(target_.pixels + span.row * target_.pitch_bytes + span.start * px_bytes_, pixels,
                  span.count * px_bytes_);
      pixels += span.count * px_bytes_;
    }
  }

  /// A pair of neighbours is known by its clockwise first, so there is at most one overlap per source.
  void close(const LutBlock& block, uint32_t index) {
    uint32_t at = block.first_overlap;
    for (uint32_t i = 0; i < block.source_count; ++i) {
      OverlapBlock& overlap = overlaps_[i];
      if (overlap.pixels == 0) continue;
      overlap.camera_a = block.sources[i].camera;
      overlap.camera_b = block.sources[overlap.camera_b].camera;
      overlap.block = index;
      overlap.q2_a = block.overlaps[i].q2_first;
      overlap.q2_b = block.overlaps[i].q2_second;
      statistics_->put(at++, overlap);
    }
  }

  const GeometricLut& lut_;
  std::span<const Picture> frames_;
  const ToneMapping& tone_mapping_;
  const Picture& out_;
  OverlapStatistics* statistics_;
  const Stages& stages_;
  const Packing& packing_;
  const size_t px_bytes_;
  Prefetch prefetch_;
  ConvertedBoxes converted_;
  std::array<ToneTables, kMaxCameras> tone_;
  std::array<Source, 4> sources_;
  std::array<OverlapBlock, 4> overlaps_;
  Picture target_;      // of the block
  bool whole_ = false;  // the region is all of it
  Samples first_;
  Samples second_;
  alignas(kLargestVector) uint8_t weights_[kStagePixels];
  alignas(kLargestVector) uint8_t packed_[kPackedPixels * kMostBytesPerPx];
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

bool is_bgrx(const Picture& picture) {
  return picture.format == PixelFormat::kBgrx8;
}

void check(const LutHeader& header, std::span<const Picture> frames, const Picture& out,
           const OverlapStatistics* statistics) {
  require(frames.size() == header.camera_count, "expected as many frames as the LUT has cameras");
  for (size_t i = 0; i < frames.size(); ++i)
    require(frames[i].empty() || fits(frames[i], header.image_size_px[i][0], header.image_size_px[i][1]),
            "a frame is not of the size that the LUT was made for, or has not the even size of its format");
  require(std::none_of(frames.begin(), frames.end(), is_bgrx), "a frame is BGRX, which no camera gives");
  require(!out.empty() && out.format != PixelFormat::kYuyv, "the output is neither BGR, BGRX nor NV12");
  require(out.width_px == header.width && out.height_px == header.height,
          "the output is not of the view's size");
  require(colour::has_whole_groups(out.format, out.width_px, out.height_px),
          "NV12 needs a view of even width and height");
  require(!statistics || statistics->capacity >= header.overlap_count, "the statistics' memory is too small");
  require(!statistics || statistics->count == header.overlap_count,
          "the statistics do not expect the overlaps of the LUT");
}

Picture checked_picture(const cv::Mat& bgr) {
  require(bgr.empty() || bgr.type() == CV_8UC3, "a cv::Mat is not BGR");
  return colour::bgr_picture(bgr);
}

}  // namespace

void synthesize(const GeometricLut& lut, std::span<const Picture> frames, const ToneMapping& tone_mapping,
                const Picture& out, OverlapStatistics* statistics, Kernel kernel) {
  if (statistics) statistics->expect(lut.header().overlap_count);
  synthesize_part({}, lut, frames, tone_mapping, out, statistics, kernel);
}

void synthesize_part(const Part& part, const GeometricLut& lut, std::span<const Picture> frames,
                     const ToneMapping& tone_mapping, const Picture& out, OverlapStatistics* statistics,
                     Kernel kernel) {
  require(can_run(kernel), "this processor does not run the kernel");
  check(lut.header(), frames, out, statistics);
  Synthesis synthesis(lut, frames, tone_mapping, out, statistics, kernel);
  const auto blocks = lut.blocks();
  const size_t begin = blocks.size() * part.index / part.count;
  const size_t end = blocks.size() * (part.index + 1) / part.count;
  for (size_t i = begin; i < end; ++i) {
    const LutBlock* next = i + 1 < end ? &blocks[i + 1] : nullptr;
    synthesis.run(blocks[i], static_cast<uint32_t>(i), next);
  }
}

void synthesize(const GeometricLut& lut, std::span<const cv::Mat> frames, const ToneMapping& tone_mapping,
                cv::Mat& out, OverlapStatistics* statistics, Kernel kernel) {
  std::array<Picture, kMaxCameras> pictures;
  require(frames.size() <= pictures.size(), "more frames than cameras there can be");
  for (size_t i = 0; i < frames.size(); ++i) pictures[i] = checked_picture(frames[i]);
  synthesize(lut, std::span<const Picture>(pictures.data(), frames.size()), tone_mapping,
             checked_picture(out), statistics, kernel);
}

}  // namespace svchain::synthesis
