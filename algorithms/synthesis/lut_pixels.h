#pragma once
// A geometric LUT pixel by pixel, for whatever is not a kernel. Any thread.

#include "algorithms/synthesis/fixed_point.h"
#include "algorithms/synthesis/geometric_lut.h"

namespace svchain::synthesis {

/// One pixel of the composite, with what the lists hold for it. A region of one camera has only the first
/// entry.
struct LutPixel {
  int column, row;  // in the composite
  const LutRegion* region;
  uint32_t first, second;  // entries
  uint8_t weight;
  const uint8_t* background;
};

/// Calls visit(LutPixel) for every pixel of a block, region by region.
template <class Visit>
void for_each_pixel(const GeometricLut& lut, const LutBlock& block, Visit visit) {
  const LutSpan* span = lut.spans(block).data();
  const uint32_t* entries = lut.entries(block);
  const uint8_t* weights = lut.weights(block);
  const uint8_t* background = lut.background(block);
  for (const LutRegion& region : lut.regions(block)) {
    const bool blends = region.kind == RegionKind::kBlend;
    const bool sampled = region.tap_count() > 0;
    size_t n = 0;
    for (const LutSpan* const end = span + region.span_count; span != end; ++span)
      for (int i = 0; i < span->count; ++i, ++n)
        visit(LutPixel{block.x + span->start + i, block.y + span->row, &region, sampled ? entries[n] : 0,
                       blends ? entries[region.pixels + n] : 0, blends ? weights[n] : uint8_t{0},
                       region.kind == RegionKind::kBackground ? background + 3 * n : nullptr});
    entries += n * region.tap_count();
    if (blends) weights += n;
    if (region.kind == RegionKind::kBackground) background += 3 * n;
  }
}

}  // namespace svchain::synthesis
