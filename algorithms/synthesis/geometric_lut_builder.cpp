#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "algorithms/synthesis/camera_reach.h"
#include "algorithms/synthesis/camera_shares.h"
#include "algorithms/synthesis/fixed_point.h"
#include "algorithms/synthesis/geometric_lut.h"
#include "algorithms/synthesis/lut_writer.h"
#include "algorithms/synthesis/vehicle_silhouette.h"

namespace svchain::synthesis {
namespace {

constexpr size_t kContentAlignment = 64;  // a block's content starts on a cache line
constexpr size_t kMostRegions = 10;       // black, background, four cameras, four pairs of neighbours
constexpr size_t kBlockPixels = kBlockSize * kBlockSize;

/// One camera's part in one pixel: where to sample, in 1/32 px of the camera's image.
struct Tap {
  int camera = 0;
  int x = 0;
  int y = 0;
};

/// One pixel of the composite. `taps` holds one for a camera, two for a blend.
struct Cell {
  RegionKind kind = RegionKind::kBlack;
  uint8_t weight = 0;
  Tap taps[2];

  int tap_count() const { return kind == RegionKind::kBlend ? 2 : kind == RegionKind::kCamera ? 1 : 0; }
};

/// Decides what a pixel shows.
class CellMaker {
 public:
  CellMaker(const geometry::Rig& rig, const RaysFromGround& rays, const geometry::View& view,
            const BlendShape& shape)
      : rig_(rig), view_(view), shape_(shape) {
    for (size_t i = 0; i < rays.size(); ++i) reaches_.emplace_back(rig.cameras[i], rays[i], rig.vehicle);
  }

  Cell make(int column, int row) const {
    const Eigen::Vector2d ground = view_.ground_from_pixel({column, row});
    if (is_under_vehicle(rig_.vehicle, ground)) return {RegionKind::kBackground, 0, {}};
    const CameraShares shares = camera_shares(rig_.vehicle, shape_, ground);
    return shares.share_of_first >= 0.5 ? make(ground, shares.first, shares.second, shares)
                                        : make(ground, shares.second, shares.first, shares);
  }

 private:
  /// Projection is what building costs, so the lesser camera is asked only where it can matter.
  Cell make(const Eigen::Vector2d& ground, int main, int other, const CameraShares& shares) const {
    const auto main_seen = reaches_[main].see(ground);
    const bool alone = main == shares.first ? shares.share_of_first >= 1 : shares.share_of_first <= 0;
    if (alone && main_seen && main_seen->fade >= 1) return one(tap(main, *main_seen));

    const auto other_seen = reaches_[other].see(ground);
    const double main_fade = main_seen ? main_seen->fade : 0;
    const double other_fade = other_seen ? other_seen->fade : 0;
    if (main_fade <= 0 && other_fade <= 0) return {};

    const bool in_order = main == shares.first;
    const int weight = first_weight(shape_, shares.share_of_first, in_order ? main_fade : other_fade,
                                    in_order ? other_fade : main_fade);
    const int main_weight = in_order ? weight : 255 - weight;
    if (main_weight == 255) return one(tap(main, *main_seen));
    if (main_weight == 0) return one(tap(other, *other_seen));
    Cell cell{RegionKind::kBlend,
              static_cast<uint8_t>(shown_weight(shape_, weight)),
              {tap(main, *main_seen), tap(other, *other_seen)}};
    if (!in_order) std::swap(cell.taps[0], cell.taps[1]);
    return cell;
  }

  static Cell one(const Tap& tap) { return {RegionKind::kCamera, 0, {tap, {}}}; }

  /// Rounds, and keeps the right and lower neighbour of the sample within the image.
  Tap tap(int camera, const CameraReach::Seen& seen) const {
    const Eigen::Vector2i& size = rig_.cameras[camera].image_size_px;
    const auto fixed = [](double px, int length) {
      const int largest = (length - 1) * int{kOnePixel} - 1;
      return std::clamp(static_cast<int>(std::lround(px * kOnePixel)), 0, largest);
    };
    return {camera, fixed(seen.pixel.x(), size.x()), fixed(seen.pixel.y(), size.y())};
  }

  const geometry::Rig& rig_;
  const geometry::View& view_;
  const BlendShape& shape_;
  std::vector<CameraReach> reaches_;
};

/// Turns the cells of one block after the other into the LUT's lists.
class BlockWriter {
 public:
  BlockWriter(LutWriter& writer, LutHeader& header, const cv::Mat& background)
      : writer_(writer), header_(header), background_(background) {}

  /// `cells` are the block's, row by row.
  void write(LutBlock& block, const Cell* cells) {
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
    writer_.align(kContentAlignment);
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

 private:
  void find_sources(LutBlock& block, const Cell* cells) {
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

  void find_overlaps(LutBlock& block, const Cell* cells) {
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

  double q2(const Tap& tap) const {
    const auto& centre = header_.lens_centre[tap.camera];
    const RadialScale scale = RadialScale::of(header_.image_size_px[tap.camera][0]);
    return double(scale.q2(tap.x - centre[0], tap.y - centre[1])) / kRadialOne;
  }

  void find_rows(const LutBlock& block, const Cell* cells) {
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
  /// To hold pixel x and its right neighbour.
  static void widen(LutRow& row, int x) {
    const int left = row.count == 0 ? x : std::min<int>(row.start, x);
    const int right = std::max(row.start + row.count, x + 2);
    row = {static_cast<uint16_t>(left), static_cast<uint16_t>(right - left)};
  }

  /// By the order in which their first pixels come.
  void find_regions(const LutBlock& block, const Cell* cells) {
    for (int i = 0; i < block.width * block.height; ++i) {
      const LutRegion region = region_of(cells[i]);
      const auto same = [&](const LutRegion& other) { return is_same(other, region); };
      if (std::none_of(regions_.begin(), regions_.end(), same)) regions_.push_back(region);
    }
  }
  LutRegion region_of(const Cell& cell) const {
    LutRegion region{cell.kind, 0, 0, 0, 0, 0};
    if (cell.tap_count() > 0) region.first = source_of_camera_[cell.taps[0].camera];
    if (cell.tap_count() > 1) region.second = source_of_camera_[cell.taps[1].camera];
    return region;
  }
  static bool is_same(const LutRegion& a, const LutRegion& b) {
    return a.kind == b.kind && a.first == b.first && a.second == b.second;
  }

  void add_region(const LutBlock& block, const Cell* cells, LutRegion& region) {
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
          pixels_.push_back(background_pixel(block.x + column, block.y + row));
      }
    }
    region.span_count = static_cast<uint16_t>(spans_.size() - first_span);
    region.pixels = static_cast<uint16_t>(members.size());
    add_taps(block, region, members);
  }

  std::array<uint8_t, 3> background_pixel(int column, int row) const {
    const auto& pixel = background_.at<cv::Vec3b>(row, column);
    return {pixel[0], pixel[1], pixel[2]};
  }

  void add_taps(const LutBlock& block, const LutRegion& region, const std::vector<const Cell*>& members) {
    for (int i = 0; i < region.tap_count(); ++i) {
      const LutSource& source = block.sources[i == 0 ? region.first : region.second];
      for (const Cell* cell : members)
        entries_.push_back(
            make_entry(cell->taps[i].x - source.x * kOnePixel, cell->taps[i].y - source.y * kOnePixel));
    }
    if (region.kind == RegionKind::kBlend)
      for (const Cell* cell : members) weights_.push_back(cell->weight);
  }

  LutWriter& writer_;
  LutHeader& header_;
  const cv::Mat& background_;
  std::array<uint8_t, 4> source_of_camera_ = {};
  std::vector<LutRow> rows_;
  std::vector<LutRegion> regions_;
  std::vector<LutSpan> spans_;
  std::vector<uint32_t> entries_;
  std::vector<uint8_t> weights_;
  std::vector<std::array<uint8_t, 3>> pixels_;
};

void check_count(const geometry::Rig& rig) {
  if (rig.cameras.size() != 4) refuse("expected four cameras, got " + std::to_string(rig.cameras.size()));
}

void check(const geometry::Rig& rig, const geometry::View& view, const BlendShape& shape) {
  check_count(rig);
  for (const auto& camera : rig.cameras)
    if (!camera.lens || camera.image_size_px.minCoeff() < 2 || camera.image_size_px.maxCoeff() > 0xFFFF)
      refuse("camera " + camera.name + " has no lens, or an image that is not 2 to 65535 px wide and high");
  if (view.size_px.minCoeff() < 1 || view.size_px.maxCoeff() > 0xFFFF || !(view.metres_per_px > 0))
    refuse("the view is " + std::to_string(view.size_px.x()) + " x " + std::to_string(view.size_px.y()) +
           " px at " + std::to_string(view.metres_per_px) + " m, expected 1 to 65535 px and more than 0 m");
  if (!(shape.width_deg >= 0 && shape.width_deg <= 90))
    refuse("the blend is " + std::to_string(shape.width_deg) + " degrees wide, expected 0 to 90");
}

/// 1/32 px. Falloff is about the axis; a lens that does not see it is one whose image has no such centre.
std::array<int32_t, 2> lens_centre(const geometry::Camera& camera) {
  const auto centre = camera.lens->project({0, 0, 1});
  const Eigen::Vector2d px =
      centre ? *centre : (camera.image_size_px.cast<double>() - Eigen::Vector2d::Ones()) / 2;
  return {static_cast<int32_t>(std::lround(px.x() * kOnePixel)),
          static_cast<int32_t>(std::lround(px.y() * kOnePixel))};
}

void fill_header(LutHeader& header, const geometry::Rig& rig, const geometry::View& view) {
  header.magic = kLutMagic;
  header.version = kLutVersion;
  header.camera_count = 4;
  header.block_count = static_cast<uint32_t>(block_count(view.size_px));
  header.width = view.size_px.x();
  header.height = view.size_px.y();
  header.metres_per_px = view.metres_per_px;
  header.centre_m[0] = view.centre_m.x();
  header.centre_m[1] = view.centre_m.y();
  for (int i = 0; i < 4; ++i) {
    const geometry::Camera& camera = rig.cameras[i];
    header.image_size_px[i] = {camera.image_size_px.x(), camera.image_size_px.y()};
    header.lens_centre[i] = lens_centre(camera);
  }
}

}  // namespace

size_t geometric_lut_capacity(const geometry::View& view, size_t cameras) {
  const size_t taps = std::min<size_t>(cameras, 2);
  const size_t blocks = block_count(view.size_px);
  const size_t pixel = taps * sizeof(uint32_t) + 1 + sizeof(LutSpan);  // a blend, in a span of its own
  const size_t lists = kMostRegions * sizeof(LutRegion) + kMostRows * sizeof(LutRow);
  return sizeof(LutHeader) + blocks * (sizeof(LutBlock) + lists + kContentAlignment) +
         size_t(view.size_px.x()) * view.size_px.y() * pixel;
}

RaysFromGround rays_from_ground(const geometry::Rig& rig) {
  check_count(rig);
  RaysFromGround rays;
  for (size_t i = 0; i < rays.size(); ++i)
    rays[i] = geometry::ray_from_ground(rig.cameras[i].vehicle_from_camera);
  return rays;
}

size_t build_geometric_lut(const geometry::Rig& rig, const geometry::View& view, const BlendShape& shape,
                           std::span<std::byte> memory) {
  return build_geometric_lut(rig, rays_from_ground(rig), view, shape, memory);
}

size_t build_geometric_lut(const geometry::Rig& rig, const RaysFromGround& rays, const geometry::View& view,
                           const BlendShape& shape, std::span<std::byte> memory) {
  check(rig, view, shape);
  if (reinterpret_cast<uintptr_t>(memory.data()) % alignof(LutHeader) != 0)
    refuse("the memory is not aligned");

  LutWriter writer(memory);
  LutHeader& header = *writer.append<LutHeader>(1);
  fill_header(header, rig, view);
  LutBlock* block = writer.append<LutBlock>(header.block_count);

  const cv::Mat background = vehicle_silhouette(rig.vehicle, view);
  const CellMaker maker(rig, rays, view, shape);
  BlockWriter blocks(writer, header, background);
  std::vector<Cell> cells(kBlockPixels);
  for (int top = 0; top < header.height; top += kBlockSize)
    for (int left = 0; left < header.width; left += kBlockSize, ++block) {
      block->x = static_cast<uint16_t>(left);
      block->y = static_cast<uint16_t>(top);
      block->width = static_cast<uint16_t>(std::min(kBlockSize, header.width - left));
      block->height = static_cast<uint16_t>(std::min(kBlockSize, header.height - top));
      Cell* cell = cells.data();
      for (int row = top; row < top + block->height; ++row)
        for (int column = left; column < left + block->width; ++column) *cell++ = maker.make(column, row);
      blocks.write(*block, cells.data());
    }
  header.bytes = writer.used();
  return header.bytes;
}

}  // namespace svchain::synthesis
