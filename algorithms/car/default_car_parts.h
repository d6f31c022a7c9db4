#pragma once
// The pieces of the default car, for a car of 4.8 m x 1.9 m (body_shape.h), and what they are made of.

#include <vector>

#include "algorithms/car/surface_grid.h"

namespace svchain::car {

enum Substance : uint32_t {
  kPaint,
  kTrim,
  kUnderbody,
  kInterior,
  kTyre,
  kRim,
  kDisc,
  kLightFront,
  kLightRear,
  kChrome,
  kPlate,
  kGlass,
};

/// In the order of Substance.
const std::vector<Material>& substances();

/// The skin from floor to deck with its wheel arches, and what is set into it: lights, grilles, doors.
void add_body(SurfaceCollector& surfaces);
/// Windows, pillars, roof, and what is seen through them.
void add_cabin(SurfaceCollector& surfaces);
/// On the left and on the right of an axle.
void add_wheels(SurfaceCollector& surfaces, float axle);

}  // namespace svchain::car
