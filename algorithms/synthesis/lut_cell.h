#pragma once
// What one pixel of a composite shows, before it is written into a LUT. Plain values.

#include <cstdint>

#include "algorithms/geometry/rig.h"
#include "algorithms/synthesis/geometric_lut.h"
#include "algorithms/synthesis/point_sources.h"

namespace svchain::synthesis {

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

/// Rounds places, and keeps the right and lower neighbour of a sample within its image.
Cell make_cell(const PointSources& sources, const geometry::Rig& rig);

}  // namespace svchain::synthesis
