#include "algorithms/synthesis/lut_block_writer.h"

#include <algorithm>
#include <string>

#include "algorithms/synthesis/fixed_point.h"

namespace svchain::synthesis {
namespace {

bool show_alike(const Cell& a, const Cell& b) {
  if (a.kind != b.kind) return false;
  const int taps = a.tap_count();
  return (taps < 1 || a.taps[0].camera == b.taps[0].camera) &&
         (taps < 2 || a.taps[1].camera == b.taps[1].camera);
}

std::array<uint8_t, 3> pixel_of(const cv::Mat& picture, int column, int row) {
  const auto& pixel = picture.at<cv::Vec3b>(row, column);
  return {pixel[0], pixel[1], pixel[2]};
}

}  // namespace

void LutBlockWriter::write(LutBlock& block, const Cell* cells) {
  spans_.clear();
  entries_.clear();
  weights_.clear();
  pixels_.clear();
  find_runs(block, cells);
  find_sources(block, cells);
  find_overlaps(block, cells);
  find_rows(block, cells);
  regions_.assign(kinds_.size(), LutRegion{});
  for (size_t region = 0; region < regions_.size(); ++region) add_region(block, cells, region);
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

void LutBlockWriter::find_runs(const LutBlock& block, const Cell* cells) {
  runs_.clear();
  kinds_.clear();
  for (int row = 0; row < block.height; ++row)
    for (int first = row * block.width, end = first + block.width; first < end;) {
      int last = first;
      while (last + 1 < end && show_alike(cells[first], cells[last + 1])) ++last;
      const auto same = [&](const Cell& kind) { return show_alike(kind, cells[first]); };
      const auto region = std::find_if(kinds_.begin(), kinds_.end(), same) - kinds_.begin();
      if (region == std::ssize(kinds_)) kinds_.push_back(cells[first]);
      runs_.push_back({first, last + 1 - first, static_cast<size_t>(region)});
      first = last + 1;
    }
}

void LutBlockWriter::find_sources(LutBlock& block, const Cell* cells) {
  struct Bounds {
    int left = 1 << 30, top = 1 << 30, right = -1, bottom = -1;  // first and last, 1/32 px
  };
  std::array<Bounds, 4> bounds;
  for (const Run& run : runs_)
    for (int i = 0; i < kinds_[run.region].tap_count(); ++i) {
      Bounds& of_camera = bounds[kinds_[run.region].taps[i].camera];
      Bounds b = of_camera;
      for (const Cell* cell = cells + run.first; cell != cells + run.first + run.count; ++cell) {
        const Tap& tap = cell->taps[i];
        b.left = std::min(b.left, tap.x);
        b.top = std::min(b.top, tap.y);
        b.right = std::max(b.right, tap.x);
        b.bottom = std::max(b.bottom, tap.y);
      }
      of_camera = b;
    }
  for (int camera = 0; camera < 4; ++camera) {
    const Bounds& b = bounds[camera];
    if (b.right < 0) continue;
    const int left = b.left >> kFractionBits, top = b.top >> kFractionBits;
    const int width = (b.right >> kFractionBits) + 2 - left, height = (b.bottom >> kFractionBits) + 2 - top;
    if (std::max(width, height) > kLargestBox)
      refuse("the block at " + std::to_string(block.x) + ", " + std::to_string(block.y) + " takes " +
             std::to_string(width) + " x " + std::to_string(height) + " px of camera " +
             std::to_string(camera) + ", expected at most " + std::to_string(kLargestBox) +
             " each way: the view is too coarse");
    source_of_camera_[camera] = static_cast<uint8_t>(block.source_count);
    block.sources[block.source_count++] = {static_cast<uint16_t>(camera), static_cast<uint16_t>(left),
                                           static_cast<uint16_t>(top), static_cast<uint16_t>(width),
                                           static_cast<uint16_t>(height)};
  }
}

/// Of each overlap, by its first camera, the mean q^2 in both of its cameras.
void LutBlockWriter::find_overlaps(LutBlock& block, const Cell* cells) {
  std::array<std::array<double, 2>, 4> sums = {};
  std::array<int, 4> pixels = {};
  for (const Run& run : runs_) {
    const Cell& kind = kinds_[run.region];
    if (kind.kind != RegionKind::kBlend) continue;
    const int overlap = kind.taps[0].camera;
    pixels[overlap] += run.count;
    for (int i = 0; i < 2; ++i) {
      const auto& centre = header_.lens_centre[kind.taps[i].camera];
      const RadialScale scale = RadialScale::of(header_.image_size_px[kind.taps[i].camera][0]);
      for (const Cell* cell = cells + run.first; cell != cells + run.first + run.count; ++cell)
        sums[overlap][i] += scale.q2(cell->taps[i].x - centre[0], cell->taps[i].y - centre[1]);
    }
  }
  block.first_overlap = header_.overlap_count;
  for (int camera = 0; camera < 4; ++camera) {
    if (pixels[camera] == 0) continue;
    ++header_.overlap_count;
    const auto mean = [&](double sum) { return static_cast<float>(sum / kRadialOne / pixels[camera]); };
    block.overlaps[source_of_camera_[camera]] = {mean(sums[camera][0]), mean(sums[camera][1])};
  }
}

void LutBlockWriter::find_rows(const LutBlock& block, const Cell* cells) {
  std::array<size_t, 4> first = {};  // by source
  size_t count = 0;
  for (uint32_t i = 0; i < block.source_count; ++i) {
    first[i] = count;
    count += block.sources[i].height;
  }
  rows_.clear();
  if (count > kMostRows) return;
  reaches_.assign(count, Reach{});
  for (const Run& run : runs_)
    for (int i = 0; i < kinds_[run.region].tap_count(); ++i) {
      const uint8_t number = source_of_camera_[kinds_[run.region].taps[i].camera];
      const LutSource& source = block.sources[number];
      Reach* const rows = &reaches_[first[number]];
      for (const Cell* cell = cells + run.first; cell != cells + run.first + run.count; ++cell) {
        const int x = cell->taps[i].x >> kFractionBits;
        Reach& reach = rows[(cell->taps[i].y >> kFractionBits) - source.y];
        reach.left = std::min(reach.left, x - source.x);
        reach.right = std::max(reach.right, x - source.x + 1);
      }
    }
  // A sample takes the row below its own as well.
  rows_.assign(count, LutRow{});
  for (uint32_t i = 0; i < block.source_count; ++i)
    for (size_t row = first[i]; row < first[i] + block.sources[i].height; ++row) {
      Reach reach = reaches_[row];
      if (row > first[i]) {
        reach.left = std::min(reach.left, reaches_[row - 1].left);
        reach.right = std::max(reach.right, reaches_[row - 1].right);
      }
      if (reach.right >= 0)
        rows_[row] = {static_cast<uint16_t>(reach.left), static_cast<uint16_t>(reach.right + 1 - reach.left)};
    }
}

void LutBlockWriter::add_region(const LutBlock& block, const Cell* cells, size_t number) {
  const Cell& kind = kinds_[number];
  LutRegion& region = regions_[number];
  region.kind = kind.kind;
  if (region.tap_count() > 0) region.first = source_of_camera_[kind.taps[0].camera];
  if (region.tap_count() > 1) region.second = source_of_camera_[kind.taps[1].camera];
  for (const Run& run : runs_) {
    if (run.region != number) continue;
    const int row = run.first / block.width, column = run.first % block.width;
    spans_.push_back(
        {static_cast<uint8_t>(row), static_cast<uint8_t>(column), static_cast<uint8_t>(run.count)});
    ++region.span_count;
    region.pixels = static_cast<uint16_t>(region.pixels + run.count);
    if (region.kind == RegionKind::kBackground)
      for (int i = 0; i < run.count; ++i)
        pixels_.push_back(pixel_of(background_, block.x + column + i, block.y + row));
  }
  add_taps(block, cells, number);
}

void LutBlockWriter::add_taps(const LutBlock& block, const Cell* cells, size_t number) {
  const LutRegion& region = regions_[number];
  for (int i = 0; i < region.tap_count(); ++i) {
    const LutSource& source = block.sources[i == 0 ? region.first : region.second];
    const int left = source.x * int{kOnePixel}, top = source.y * int{kOnePixel};
    size_t at = entries_.size();
    entries_.resize(at + region.pixels);
    for (const Run& run : runs_) {
      if (run.region != number) continue;
      for (const Cell* cell = cells + run.first; cell != cells + run.first + run.count; ++cell)
        entries_[at++] = make_entry(cell->taps[i].x - left, cell->taps[i].y - top);
    }
  }
  if (region.kind != RegionKind::kBlend) return;
  for (const Run& run : runs_) {
    if (run.region != number) continue;
    for (int i = 0; i < run.count; ++i) weights_.push_back(cells[run.first + i].weight);
  }
}

}  // namespace svchain::synthesis
