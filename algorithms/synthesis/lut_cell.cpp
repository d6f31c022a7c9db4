#include "algorithms/synthesis/lut_cell.h"

#include <algorithm>
#include <cmath>

#include "algorithms/synthesis/fixed_point.h"

namespace svchain::synthesis {
namespace {

int fixed(double px, int length) {
  const int largest = (length - 1) * int{kOnePixel} - 1;
  return std::clamp(static_cast<int>(std::lround(px * kOnePixel)), 0, largest);
}

}  // namespace

Cell make_cell(const PointSources& sources, const geometry::Rig& rig) {
  constexpr RegionKind kKinds[] = {RegionKind::kBlack, RegionKind::kCamera, RegionKind::kBlend};
  Cell cell;
  cell.kind = kKinds[sources.count];
  if (sources.count == 2) cell.weight = static_cast<uint8_t>(sources.first_weight);
  for (int i = 0; i < sources.count; ++i) {
    const Eigen::Vector2i& size = rig.cameras[sources.camera[i]].image_size_px;
    const Eigen::Vector2d& px = sources.image_px[i];
    cell.taps[i] = {sources.camera[i], fixed(px.x(), size.x()), fixed(px.y(), size.y())};
  }
  return cell;
}

}  // namespace svchain::synthesis
