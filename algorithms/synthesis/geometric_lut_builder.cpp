#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "algorithms/synthesis/fixed_point.h"
#include "algorithms/synthesis/geometric_lut.h"
#include "algorithms/synthesis/lut_block_writer.h"
#include "algorithms/synthesis/lut_cell.h"
#include "algorithms/synthesis/lut_header.h"
#include "algorithms/synthesis/lut_writer.h"
#include "algorithms/synthesis/point_sources.h"
#include "algorithms/synthesis/vehicle_silhouette.h"

namespace svchain::synthesis {
namespace {

constexpr size_t kMostRegions = 10;  // black, background, four cameras, four pairs of neighbours
constexpr size_t kBlockPixels = kBlockSize * kBlockSize;

/// As on the ground, whatever is above it.
std::vector<RayFromPoint> rays_from_point(const RaysFromGround& rays) {
  std::vector<RayFromPoint> all;
  for (const Eigen::Matrix3d& ray : rays)
    all.emplace_back() << ray.leftCols<2>(), Eigen::Vector3d::Zero(), ray.col(2);
  return all;
}

/// Decides what a pixel of a view of the ground shows.
class GroundCells {
 public:
  GroundCells(const geometry::Rig& rig, const RaysFromGround& rays, const geometry::View& view,
              const BlendShape& shape)
      : rig_(rig), view_(view), finder_(rig, rays_from_point(rays), shape) {}

  Cell make(int column, int row) const {
    const Eigen::Vector2d ground = view_.ground_from_pixel({column, row});
    if (is_under_vehicle(rig_.vehicle, ground)) return {RegionKind::kBackground, 0, {}};
    return make_cell(finder_.find({ground.x(), ground.y(), 0}), rig_);
  }

 private:
  const geometry::Rig& rig_;
  const geometry::View& view_;
  SourceFinder finder_;
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

}  // namespace

size_t geometric_lut_capacity(const geometry::View& view, size_t cameras) {
  const size_t taps = std::min<size_t>(cameras, 2);
  const size_t blocks = block_count(view.size_px);
  const size_t pixel = taps * sizeof(uint32_t) + 1 + sizeof(LutSpan);  // a blend, in a span of its own
  const size_t lists = kMostRegions * sizeof(LutRegion) + kMostRows * sizeof(LutRow);
  return sizeof(LutHeader) + blocks * (sizeof(LutBlock) + lists + kLutContentAlignment) +
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
  require_aligned(memory);

  LutWriter writer(memory);
  LutHeader& header = *writer.append<LutHeader>(1);
  fill_header(header, rig, view.size_px);
  header.metres_per_px = view.metres_per_px;
  header.centre_m[0] = view.centre_m.x();
  header.centre_m[1] = view.centre_m.y();
  LutBlock* block = writer.append<LutBlock>(header.block_count);

  const cv::Mat background = vehicle_silhouette(rig.vehicle, view);
  const GroundCells ground(rig, rays, view, shape);
  LutBlockWriter blocks(writer, header, background);
  std::vector<Cell> cells(kBlockPixels);
  for (int top = 0; top < header.height; top += kBlockSize)
    for (int left = 0; left < header.width; left += kBlockSize, ++block) {
      block->x = static_cast<uint16_t>(left);
      block->y = static_cast<uint16_t>(top);
      block->width = static_cast<uint16_t>(std::min(kBlockSize, header.width - left));
      block->height = static_cast<uint16_t>(std::min(kBlockSize, header.height - top));
      Cell* cell = cells.data();
      for (int row = top; row < top + block->height; ++row)
        for (int column = left; column < left + block->width; ++column) *cell++ = ground.make(column, row);
      blocks.write(*block, cells.data());
    }
  header.bytes = writer.used();
  return header.bytes;
}

}  // namespace svchain::synthesis
