#include "algorithms/synthesis/lut_block_writer.h"

#include <algorithm>
#include <string>

#include "algorithms/synthesis/fixed_point.h"

namespace svchain::synthesis {
namespace {

/// To hold pixel x and its right neighbour.
void widen(LutRow& row, int x) {
  const int left = row.count == 0 ? x : std::min<int>(row.start, x);
  const int right = std::max(row.start + row.count, x + 2);
  row = {static_cast<uint16_t>(left), static_cast<uint16_t>(right - left)};
}

bool is_same(const LutRegion& a, const LutRegion& b) {
  return a.kind == b.kind && a.first == b.first && a.second == b.second;
}

std::array<uint8_t, 3> pixel_of(const cv::Mat& picture, int column, int row) {
  const auto& pixel = picture.at<cv::Vec3b>(row, column);
  return {pixel[0], pixel[1], pixel[2]};
}

}  // namespace

void LutBlockWriter::write(LutBlock& block, const Cell* cells) {
  rows_.clear();
  regions_.clear();
  spans_.clear();
  entries_.clear();
  weights_.clear();
  pixels_.clear();
  find_sources(block, cells);
  find_overlaps(block, cells);
  find_rows(block, cells);
  find_regions(block, cells);
  for (LutRegion& region : regions_) add_region(block, cells, region);
  writer_.align(kLutContentAlignment);
  block.entry_count = static_cast<uint32_t>(entries_.size());
  block.row_count = static_cast<uint32_t>(rows_.size());
  block.region_count = static_cast<uint32_t>(regions_.size());
  block.span_count = static_cast<uint32_t>(spans_.size());
  block.weight_count = static_cast<uint32_t>(weights_.size());
  block.background_count = static_cast<uint32_t>(pixels_.size());
  block.entries_at = writer_.append(entries_);
  block.rows_at = writer_.append(rows_);
  block.regions_at = writer_.append(regions_);
  block.spans_at = writer_.append(spans_);
  block.weights_at = writer_.append(weights_);
  block.background_at = writer_.append(pixels_);
}

void LutBlockWriter::find_sources(LutBlock& block, const Cell* cells) {
  struct Bounds {
    int left = 1 << 30, top = 1 << 30, right = -1, bottom = -1;  // first and last pixel
  };
  std::array<Bounds, 4> bounds;
  std::array<bool, 4> overlaps = {};  // by first camera
  for (const Cell* cell = cells; cell != cells + block.width * block.height; ++cell) {
    if (cell->kind == RegionKind::kBlend) overlaps[cell->taps[0].camera] = true;
    for (int i = 0; i < cell->tap_count(); ++i) {
      const Tap& tap = cell->taps[i];
      Bounds& b = bounds[tap.camera];
      b.left = std::min(b.left, tap.x >> kFractionBits);
      b.top = std::min(b.top, tap.y >> kFractionBits);
      b.right = std::max(b.right, (tap.x >> kFractionBits) + 1);
      b.bottom = std::max(b.bottom, (tap.y >> kFractionBits) + 1);
    }
  }
  block.first_overlap = header_.overlap_count;
  header_.overlap_count += static_cast<uint32_t>(std::count(overlaps.begin(), overlaps.end(), true));
  for (int camera = 0; camera < 4; ++camera) {
    const Bounds& b = bounds[camera];
    if (b.right < 0) continue;
    const int width = b.right - b.left + 1, height = b.bottom - b.top + 1;
    if (std::max(width, height) > kLargestBox)
      refuse("the block at " + std::to_string(block.x) + ", " + std::to_string(block.y) + " takes " +
             std::to_string(width) + " x " + std::to_string(height) + " px of camera " +
             std::to_string(camera) + ", expected at most " + std::to_string(kLargestBox) +
             " each way: the view is too coarse");
    source_of_camera_[camera] = static_cast<uint8_t>(block.source_count);
    block.sources[block.source_count++] = {static_cast<uint16_t>(camera), static_cast<uint16_t>(b.left),
                                           static_cast<uint16_t>(b.top), static_cast<uint16_t>(width),
                                           static_cast<uint16_t>(height)};
  }
}

void LutBlockWriter::find_overlaps(LutBlock& block, const Cell* cells) {
  std::array<double, 4> first = {}, second = {};
  std::array<int, 4> pixels = {};  // by first camera
  for (const Cell* cell = cells; cell != cells + block.width * block.height; ++cell) {
    if (cell->kind != RegionKind::kBlend) continue;
    const int camera = cell->taps[0].camera;
    first[camera] += q2(cell->taps[0]);
    second[camera] += q2(cell->taps[1]);
    ++pixels[camera];
  }
  for (int camera = 0; camera < 4; ++camera)
    if (pixels[camera] > 0)
      block.overlaps[source_of_camera_[camera]] = {static_cast<float>(first[camera] / pixels[camera]),
                                                   static_cast<float>(second[camera] / pixels[camera])};
}

double LutBlockWriter::q2(const Tap& tap) const {
  const auto& centre = header_.lens_centre[tap.camera];
  const RadialScale scale = RadialScale::of(header_.image_size_px[tap.camera][0]);
  return double(scale.q2(tap.x - centre[0], tap.y - centre[1])) / kRadialOne;
}

void LutBlockWriter::find_rows(const LutBlock& block, const Cell* cells) {
  std::array<size_t, 4> first = {};  // by source
  size_t count = 0;
  for (uint32_t i = 0; i < block.source_count; ++i) {
    first[i] = count;
    count += block.sources[i].height;
  }
  if (count > kMostRows) return;
  rows_.assign(count, LutRow{});
  for (const Cell* cell = cells; cell != cells + block.width * block.height; ++cell)
    for (int i = 0; i < cell->tap_count(); ++i) {
      const Tap& tap = cell->taps[i];
      const uint8_t source = source_of_camera_[tap.camera];
      const int x = (tap.x >> kFractionBits) - block.sources[source].x;
      const int y = (tap.y >> kFractionBits) - block.sources[source].y;
      widen(rows_[first[source] + y], x);
      widen(rows_[first[source] + y + 1], x);
    }
}

/// By the order in which their first pixels come.
void LutBlockWriter::find_regions(const LutBlock& block, const Cell* cells) {
  for (int i = 0; i < block.width * block.height; ++i) {
    const LutRegion region = region_of(cells[i]);
    const auto same = [&](const LutRegion& other) { return is_same(other, region); };
    if (std::none_of(regions_.begin(), regions_.end(), same)) regions_.push_back(region);
  }
}
LutRegion LutBlockWriter::region_of(const Cell& cell) const {
  LutRegion region{cell.kind, 0, 0, 0, 0, 0};
  if (cell.tap_count() > 0) region.first = source_of_camera_[cell.taps[0].camera];
  if (cell.tap_count() > 1) region.second = source_of_camera_[cell.taps[1].camera];
  return region;
}

void LutBlockWriter::add_region(const LutBlock& block, const Cell* cells, LutRegion& region) {
  const size_t first_span = spans_.size();
  std::vector<const Cell*> members;
  for (int row = 0; row < block.height; ++row) {
    bool open = false;
    for (int column = 0; column < block.width; ++column) {
      const Cell& cell = cells[row * block.width + column];
      const bool member = is_same(region_of(cell), region);
      if (member && !open) spans_.push_back({static_cast<uint8_t>(row), static_cast<uint8_t>(column), 0});
      open = member;
      if (!member) continue;
      ++spans_.back().count;
      members.push_back(&cell);
      if (region.kind == RegionKind::kBackground)
        pixels_.push_back(pixel_of(background_, block.x + column, block.y + row));
    }
  }
  region.span_count = static_cast<uint16_t>(spans_.size() - first_span);
  region.pixels = static_cast<uint16_t>(members.size());
  add_taps(block, region, members);
}

void LutBlockWriter::add_taps(const LutBlock& block, const LutRegion& region,
                              const std::vector<const Cell*>& members) {
  for (int i = 0; i < region.tap_count(); ++i) {
    const LutSource& source = block.sources[i == 0 ? region.first : region.second];
    for (const Cell* cell : members)
      entries_.push_back(
          make_entry(cell->taps[i].x - source.x * kOnePixel, cell->taps[i].y - source.y * kOnePixel));
  }
  if (region.kind == RegionKind::kBlend)
    for (const Cell* cell : members) weights_.push_back(cell->weight);
}

}  // namespace svchain::synthesis
