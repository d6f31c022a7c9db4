#include "algorithms/synthesis/geometric_lut.h"

#include <stdexcept>
#include <string>

namespace svchain::synthesis {
namespace {

void require(bool condition, const std::string& message) {
  if (!condition) throw std::invalid_argument("geometric LUT: " + message);
}

size_t divide_up(size_t a, size_t b) {
  return (a + b - 1) / b;
}

}  // namespace

size_t block_count(const Eigen::Vector2i& size_px) {
  return divide_up(size_px.x(), kBlockSize) * divide_up(size_px.y(), kBlockSize);
}

GeometricLut::GeometricLut(std::span<const std::byte> memory) : memory_(memory) {
  require(reinterpret_cast<uintptr_t>(memory.data()) % alignof(LutHeader) == 0, "the memory is not aligned");
  require(memory.size() >= sizeof(LutHeader), "shorter than its header");
  const LutHeader& h = header();
  require(h.magic == kLutMagic, "the memory holds none");
  require(h.version == kLutVersion,
          "version " + std::to_string(h.version) + ", expected " + std::to_string(kLutVersion));
  require(h.bytes <= memory.size(),
          std::to_string(h.bytes) + " bytes long, but the memory has only " + std::to_string(memory.size()));
  memory_ = memory.first(h.bytes);
  require(h.camera_count <= h.image_size_px.size(), "too many cameras");
  require(h.width > 0 && h.height > 0 && h.block_count == block_count({h.width, h.height}) &&
              h.block_count <= (h.bytes - sizeof(LutHeader)) / sizeof(LutBlock),
          "the table of blocks does not fit the view");
  for (const LutBlock& block : blocks()) check_block(block);
}

void GeometricLut::check_block(const LutBlock& block) const {
  const LutHeader& h = header();
  const auto within = [&](size_t offset, size_t count, size_t size) {
    return offset <= h.bytes && count <= (h.bytes - offset) / size && offset % size == 0;
  };
  bool good = block.width <= kBlockSize && block.height <= kBlockSize && block.x + block.width <= h.width &&
              block.y + block.height <= h.height && block.source_count <= block.sources.size() &&
              within(block.entries_at, block.entry_count, sizeof(uint32_t)) &&
              within(block.weights_at, block.weight_count, 1) && block.spans_at <= h.bytes &&
              block.span_count <= (h.bytes - block.spans_at) / sizeof(LutSpan) &&
              within(block.regions_at, block.region_count, alignof(LutRegion)) &&
              block.region_count <= (h.bytes - block.regions_at) / sizeof(LutRegion) &&
              within(block.rows_at, block.row_count, alignof(LutRow)) &&
              block.row_count <= (h.bytes - block.rows_at) / sizeof(LutRow) &&
              block.background_at <= h.bytes && block.background_count <= (h.bytes - block.background_at) / 3;
  for (uint32_t i = 0; good && i < block.source_count; ++i) {
    const LutSource& source = block.sources[i];
    good = source.camera < h.camera_count && source.width >= 2 && source.height >= 2 &&
           source.x + source.width <= h.image_size_px[source.camera][0] &&
           source.y + source.height <= h.image_size_px[source.camera][1];
  }
  good = good && regions_fit(block) && rows_fit(block);
  require(good, "block at " + std::to_string(block.x) + ", " + std::to_string(block.y) + " is damaged");
}

/// The regions take exactly what the lists hold, and no pixel outside the block; their overlaps have room in
/// the statistics.
bool GeometricLut::regions_fit(const LutBlock& block) const {
  size_t pixels = 0, span_count = 0, entry_count = 0, weight_count = 0, background_count = 0;
  size_t overlap_end = block.first_overlap;
  for (const LutRegion& region : regions(block)) {
    pixels += region.pixels;
    span_count += region.span_count;
    entry_count += size_t(region.pixels) * region.tap_count();
    weight_count += region.kind == RegionKind::kBlend ? region.pixels : 0;
    overlap_end += region.kind == RegionKind::kBlend;
    background_count += region.kind == RegionKind::kBackground ? region.pixels : 0;
    if (region.kind > RegionKind::kBlend || span_count > block.span_count) return false;
    if (region.tap_count() > 0 && region.first >= block.source_count) return false;
    if (region.tap_count() > 1 && region.second >= block.source_count) return false;
    size_t covered = 0;
    for (const LutSpan& span : spans(block).subspan(span_count - region.span_count, region.span_count)) {
      if (span.row >= block.height || span.start + span.count > block.width) return false;
      covered += span.count;
    }
    if (covered != region.pixels) return false;
  }
  return pixels == size_t(block.width) * block.height && span_count == block.span_count &&
         entry_count == block.entry_count && weight_count == block.weight_count &&
         background_count == block.background_count && overlap_end <= header().overlap_count;
}

bool GeometricLut::rows_fit(const LutBlock& block) const {
  if (block.row_count == 0) return true;
  std::span<const LutRow> left = rows(block);
  for (const LutSource& source : std::span(block.sources).first(block.source_count)) {
    if (source.height > left.size()) return false;
    for (const LutRow& row : left.first(source.height))
      if (row.start + row.count > source.width) return false;
    left = left.subspan(source.height);
  }
  return left.empty();
}

GeometricLut::Footprint GeometricLut::footprint() const {
  Footprint footprint;
  footprint.bytes = header().bytes;
  footprint.bytes_per_pixel = double(header().bytes) / (double(header().width) * header().height);
  for (const LutBlock& block : blocks()) {
    size_t& kind = block.blends()           ? footprint.blend_blocks
                   : block.source_count > 0 ? footprint.one_camera_blocks
                                            : footprint.empty_blocks;
    ++kind;
    for (uint32_t i = 0; i < block.source_count; ++i)
      footprint.source_pixels += size_t{block.sources[i].width} * block.sources[i].height;
  }
  return footprint;
}

}  // namespace svchain::synthesis
