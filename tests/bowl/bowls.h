#pragma once
// Vehicles and bowls for tests.

#include <vector>

#include "algorithms/bowl/bowl_surface.h"

namespace svchain::testing {

inline constexpr geometry::Vehicle kToy = {0.6, 0.32}, kCar = {4.8, 1.9}, kVan = {6.9, 2.1};

/// The default bowl with either floor, then a steep cone and a flat one.
inline std::vector<bowl::BowlSurface> bowls(const geometry::Vehicle& vehicle) {
  const bowl::BowlSurface usual = bowl::default_surface(vehicle);
  bowl::BowlSurface ellipse = usual, cone = usual, flat = usual;
  ellipse.shape = bowl::FloorShape::kEllipse;
  cone.exponent = 1;
  cone.height_m = cone.rise_m;
  flat.height_m = 0;
  return {usual, ellipse, cone, flat};
}

}  // namespace svchain::testing
