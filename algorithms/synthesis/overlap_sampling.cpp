#include "algorithms/synthesis/overlap_sampling.h"

#include <array>
#include <stdexcept>
#include <string>

#include "algorithms/synthesis/stages.h"
#include "algorithms/synthesis/vector_stages.h"

namespace svchain::synthesis {
namespace {

/// One camera's samples of a region.
struct Side {
  FrameBox box;
  const uint32_t* entries;
  BlockSamples sums = {};
};

void add_samples(const Stages& stages, Side& side, size_t pixels, size_t step) {
  alignas(kLargestVector) uint32_t some[kStagePixels];
  Samples samples;
  for (size_t at = 0; at < pixels;) {
    size_t count = 0;
    for (; count < kStagePixels && at < pixels; at += step) some[count++] = side.entries[at];
    stages.sample(side.box, some, count, samples);
    stages.add(samples, count, side.sums);
  }
}

void require(bool condition, const char* what) {
  if (!condition) throw std::invalid_argument(std::string("overlap sampling: ") + what);
}

void check(const LutHeader& header, std::span<const colour::Picture> frames, int step,
           const OverlapStatistics& statistics) {
  require(step >= 1, "a step below 1");
  require(frames.size() == header.camera_count, "expected as many frames as the LUT has cameras");
  for (size_t i = 0; i < frames.size(); ++i)
    require(frames[i].empty() || (frames[i].width_px == header.image_size_px[i][0] &&
                                  frames[i].height_px == header.image_size_px[i][1]),
            "a frame is not of the size that the LUT was made for");
  require(statistics.capacity >= header.overlap_count, "the statistics' memory is too small");
}

}  // namespace

void sample_overlaps(const GeometricLut& lut, std::span<const colour::Picture> frames, int step,
                     OverlapStatistics& statistics, Kernel kernel) {
  check(lut.header(), frames, step, statistics);
  const Stages& stages = kernel == Kernel::kPortable ? kPortableStages : *vector_stages(kernel);
  statistics.expect(lut.header().overlap_count);
  for (size_t i = 0; i < lut.blocks().size(); ++i) {
    const LutBlock& block = lut.blocks()[i];
    const uint32_t* entries = lut.entries(block);
    std::array<OverlapBlock, 4> overlaps = {};  // by the source that is the clockwise first
    for (const LutRegion& region : lut.regions(block)) {
      if (region.kind == RegionKind::kBlend) {
        const LutSource &a = block.sources[region.first], &b = block.sources[region.second];
        Side first{FrameBox(frames[a.camera], a), entries},
            second{FrameBox(frames[b.camera], b), entries + region.pixels};
        add_samples(stages, first, region.pixels, static_cast<size_t>(step));
        add_samples(stages, second, region.pixels, static_cast<size_t>(step));
        const auto pixels = static_cast<uint32_t>((region.pixels + step - 1) / step);
        const LutOverlap& seen = block.overlaps[region.first];
        overlaps[region.first] = {a.camera,   b.camera,      static_cast<uint32_t>(i),
                                  pixels,     seen.q2_first, seen.q2_second,
                                  first.sums, second.sums};
      }
      entries += region.pixels * region.tap_count();
    }
    uint32_t at = block.first_overlap;
    for (const OverlapBlock& overlap : overlaps)
      if (overlap.pixels > 0) statistics.put(at++, overlap);
  }
}

}  // namespace svchain::synthesis
